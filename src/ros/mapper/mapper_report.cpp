#include <diagnostic_msgs/DiagnosticStatus.h>

#include <string>

#include "frontier_pilot/core/bounds.h"
#include "ros/common/clock.h"
#include "ros/mapper/mapper_adapter.h"

namespace frontier_pilot {
namespace {

using Status = diagnostic_updater::DiagnosticStatusWrapper;

constexpr double kMega = 1e-6;
constexpr double kDegrees = 180.0 / kPi;
constexpr std::size_t kManyKeyframes = 30'000;  // 300 to 600 MB, after six kilometres or less

void reportScans(const mapping::Mapper& mapper, Status& status) {
  for (std::size_t i = 0; i < mapping::kScanVerdicts; ++i) {
    const auto verdict = static_cast<mapping::ScanVerdict>(i);
    status.add(std::string("scans, ") + toString(verdict), mapper.counts()[verdict]);
  }
  status.add("scans dropped", mapper.counts().dropped());
  status.addf("unusable beams of the last scan [%]", "%.0f", 100.0 * (1.0 - mapper.usableShare()));
}

void reportCorrection(const mapping::Mapper& mapper, Status& status) {
  status.add("last pose", mapper.lastCorrection());
  for (const auto& [text, count] : mapper.correctionCounts()) status.add("poses, " + text, count);
}

void reportRevisions(const mapping::RevisionReport& revisions, Status& status) {
  status.add("loops closed", revisions.closures);
  for (std::size_t i = 0; i < slam::kClosureVerdicts; ++i) {
    const auto verdict = static_cast<slam::ClosureVerdict>(i);
    status.add(std::string("closures, ") + toString(verdict), revisions.attempts[verdict]);
  }
  status.addf("last jump [m, deg]", "%.3f, %.2f", revisions.last_jump.position().norm(),
              revisions.last_jump.yaw * kDegrees);
  status.add("map rendered again", revisions.rendered);
}

}  // namespace

void MapperAdapter::report(Status& status) const {
  summarize(status);
  reportScans(mapper_, status);
  scan_motion_.report(status);
  bad_scans_.report(status);
  bad_odometry_.report(status);
  tf_.report(status);
  bad_initial_poses_.report(status);
  reportCorrection(mapper_, status);
  reportOdometry(status);
  reportRevisions(mapper_.revisions(), status);
  status.addf("last revision took [s]", "%.3f", revision_seconds_);
  status.add("scans kept to close loops with", mapper_.keyframes());
  const GridGeometry& geometry = mapper_.map().geometry();
  status.addf("map size [m]", "%.1f x %.1f", geometry.width * geometry.resolution,
              geometry.height * geometry.resolution);
  status.addf("memory of the map's cells [MB]", "%.1f of %.0f", kMega * static_cast<double>(mapper_.map().memory()),
              parameters_.mapper.map.max_memory);
}

void MapperAdapter::summarize(Status& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  status.summary(DiagnosticStatus::OK, "mapping");
  if (const auto remark = mapper_.remark(rosNow())) {
    status.summaryf(DiagnosticStatus::WARN, "%.0f %% of the last scans: %s", 100.0 * remark->share,
                    remark->text.c_str());
  } else if (!last_inserted_) {
    const std::string& missing = connections_.inputs().missing();
    const std::string text = pairing_.hasOdometry() ? "no usable scan yet" : "no odometry yet";
    status.summary(DiagnosticStatus::WARN, missing.empty() ? text : text + ": " + missing);
  } else if (toSeconds(steadyNow() - *last_inserted_) > parameters_.silence) {
    status.summary(DiagnosticStatus::WARN, "no usable scan any more");
  }
  if (mapper_.map().geometry().size() > bounds::kMostMapCells) {
    status.mergeSummaryf(DiagnosticStatus::WARN,
                         "the map has more than the %zu cells that navigator and explorer accept: choose a coarser "
                         "resolution",
                         bounds::kMostMapCells);
  }
  if (mapper_.keyframes() > kManyKeyframes) {
    status.mergeSummaryf(
        DiagnosticStatus::WARN,
        "%zu scans are kept to close loops with, and each metre adds some: for operation over days, save "
        "the map and load it with localize_only",
        mapper_.keyframes());
  }
  if (mapper_.hasAbandonedWork()) {
    status.mergeSummary(DiagnosticStatus::WARN, "loop closing is off until a reset: " + revision_failure_);
  }
  const std::string delay = saver_.saves().delay(steadyNow());
  if (!delay.empty()) status.mergeSummary(DiagnosticStatus::WARN, delay);
  if (!publisher_.other().empty()) {
    status.summary(DiagnosticStatus::ERROR, publisher_.other() + " publishes " + publisher_.topic() + " as well");
  }
}

}  // namespace frontier_pilot
