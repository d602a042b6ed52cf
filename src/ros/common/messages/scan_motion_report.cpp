#include "ros/common/messages/scan_motion_report.h"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include "ros/common/clock.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {

bool ScanMotionReport::place(ScanPlacer& placer, LaserScan2& scan) {
  const bool covered = placer.place(ScanReference::kEnd, scan);
  return note(placer.timing(), covered, scan, placer.track().nearest(scan.stamp));
}

bool ScanMotionReport::note(const BeamTiming& timing, bool covered, const LaserScan2& scan,
                            const std::optional<Pose2>& T_odom_base) {
  constexpr std::uint64_t kFirst = 5;  // odometry may begin a little later than the scans
  covered_ = covered_ || covered;
  uncovered_ += covered ? 0 : 1;
  const bool is_news = !covered && (covered_ || uncovered_ > kFirst);
  if (is_news && log_interval_.admit(steadyNow()))
    ROS_WARN_STREAM("odometry does not cover the whole scan: the rest of its beams are put where it ends ("
                    << uncovered_ << " so far)");
  problem_ = timing.problem();
  if (!problem_.empty() && !warned_) THROTTLED_WARN("the times of the scanner's beams: " << problem_);
  warned_ = warned_ || !problem_.empty();
  return !frozen_.isFrozen(scan, T_odom_base);
}

void ScanMotionReport::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  status.add("times of the beams", problem_.empty() ? "credible" : problem_);
  status.add("scans that odometry does not cover", uncovered_);
  frozen_.report(status);
  if (problem_.empty()) return;
  status.mergeSummary(diagnostic_msgs::DiagnosticStatus::WARN, "the times of the scanner's beams are not credible");
}

}  // namespace frontier_pilot
