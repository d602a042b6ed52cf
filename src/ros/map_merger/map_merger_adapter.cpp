#include "ros/map_merger/map_merger_adapter.h"

#include <iomanip>
#include <sstream>
#include <utility>
#include <vector>

#include "ros/common/clock.h"
#include "ros/common/parameters.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

MapTopics viewOf(const std::string& robot) {
  return {names::ofRobot(robot, names::kMergedMap), names::ofRobot(robot, names::kMergedMapUpdates),
          names::ofRobot(robot, names::kMergedMapMetadata)};
}

}  // namespace

MapMergerAdapter::Robot::Robot(ros::NodeHandle& node, const std::string& robot,
                               const mapping::MapScheduleParameters& schedule)
    : name(robot), frame(names::ofRobot(robot, names::kMapFrame)), view(node, viewOf(robot), frame, schedule) {}

MapMergerAdapter::MapMergerAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : parameters_(loadNodeParameters<MapMergerNodeParameters>(private_node)),
      merger_(parameters_),
      common_(node, {names::kMap, names::kMapUpdates, names::kMapMetadata}, parameters_.map_frame,
              parameters_.publishing),
      topic_(node.resolveName(names::kMap)),
      diagnostics_(node, private_node),
      connections_(node) {
  for (const fleet::FleetRobot& robot : parameters_.robots) {
    robots_.emplace_back(node, robot.name, parameters_.publishing);
    robots_.back().map.subscribe(connections_, robots_.back().frame, robot.name);
  }
  diagnostics_.add("merging", [this](auto& status) { report(status); });
  diagnostics_.add("connections", [this](auto& status) { connections_.report(status); });
  diagnostics_.add("memory", [this](auto& status) { connections_.memory().report(status); });
  connections_.master().claimTopics({topic_});
  connections_.every(ros::Duration(1.0 / parameters_.rate), [this] {
    if (const auto now = connections_.clock().now()) tick(*now);
  });
  connections_.everySteady(ros::WallDuration(0.5), [this] { takeRivals(); });
  connections_.everySteady(ros::WallDuration(0.1), [this] { saver_.provide(merger_.common().map()); });
  saver_.serve(connections_);
}

void MapMergerAdapter::tick(Time now) {
  std::size_t i = 0;
  for (Robot& robot : robots_) {
    const CellRect changed = robot.map.takeChanged();
    if (!changed.empty()) merger_.setMap(i, robot.map.map(), changed, now);
    ++i;
  }
  searchPlaces(now);
  merger_.update(now);
  common_.publish(merger_.common().map(), merger_.common().takeChanged(), now);
  std::vector<FramePose> places;
  i = 0;
  for (Robot& robot : robots_) {
    fleet::MergedMap& view = merger_.view(i);
    robot.view.publish(view.map(), view.takeChanged(), now);
    if (const auto place = merger_.place(i)) places.push_back({parameters_.map_frame, robot.frame, *place});
    ++i;
  }
  tf_.broadcast(places, now);
}

/// Starts that are not known are looked for on a thread of its own: large maps take long.
void MapMergerAdapter::searchPlaces(Time now) {
  if (const auto finding = searcher_.take()) merger_.accept(*finding, now);
  if (const auto failure = searcher_.takeFailure()) {
    THROTTLED_ERROR("the search for a robot's place failed: " << *failure);
    merger_.accept({}, now);
  }
  if (!searcher_.idle()) return;
  if (auto work = merger_.takeWork(now, [this] { return ending_.load(); })) searcher_.start(std::move(*work));
}

void MapMergerAdapter::takeRivals() {
  const auto seen = connections_.master().take();
  if (!seen) return;
  const auto other = seen->rivals.find(topic_);
  rival_ = other == seen->rivals.end() ? "" : other->second;
  if (!rival_.empty()) THROTTLED_ERROR(rival_ << " publishes " << topic_ << " as well");
}

void MapMergerAdapter::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  std::size_t merged = 0;
  std::size_t i = 0;
  std::string left_out;
  for (const Robot& robot : robots_) {
    const fleet::MergeState state = merger_.status(i).state;
    merged += state == fleet::MergeState::kMerged ? 1 : 0;
    if (state != fleet::MergeState::kMerged) left_out += "; " + robot.name + ": " + toString(state);
    status.add(robot.name, describeMerge(i));
    robot.map.rejections().report(status);
    ++i;
  }
  const std::string summary = std::to_string(merged) + " of " + std::to_string(robots_.size()) + " robots merged";
  const bool complete = !robots_.empty() && merged == robots_.size();
  status.summary(complete ? DiagnosticStatus::OK : DiagnosticStatus::WARN,
                 robots_.empty() ? "no robots are listed" : summary + left_out);
  const std::string delay = saver_.saves().delay(steadyNow());
  if (!delay.empty()) status.mergeSummary(DiagnosticStatus::WARN, delay);
  if (!rival_.empty()) status.summary(DiagnosticStatus::ERROR, rival_ + " publishes " + topic_ + " as well");
}

std::string MapMergerAdapter::describeMerge(std::size_t robot) const {
  const fleet::MergeStatus& merge = merger_.status(robot);
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << toString(merge.state);
  if (merge.state != fleet::MergeState::kNoMap) text << " for " << toSeconds(rosNow() - merge.since) << " s";
  if (merge.windows > 0) text << ", to which " << merge.windows << " parts of its map and of another lead";
  if (merge.agreement.known == 0) return text.str();
  text << ", overlap " << merge.agreement.overlap << " m2, of which " << 100.0 * merge.agreement.agreeingShare()
       << " % agree, " << 100.0 * merge.agreement.contradictedShare() << " % of the walls contradict";
  return text.str();
}

}  // namespace frontier_pilot
