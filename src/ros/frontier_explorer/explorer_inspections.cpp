#include "ros/common/messages/conversions.h"
#include "ros/common/tf/pose_in_frame.h"
#include "ros/common/throttled_log.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"

/// The poses that the robot is to take during the exploration. [EXP-10]
namespace frontier_pilot {

void FrontierExplorerAdapter::handleInspect(const geometry_msgs::PoseStamped& msg) {
  std::string why;
  const auto pose = poseInFrame(msg, parameters_.map_frame, tf_, why);
  if (pose) why = explorer_.inspect(*pose);
  if (!pose || !why.empty()) return bad_inspections_.add(why);
  tellAtOnce();
  THROTTLED_INFO("to be inspected on the way: (" << pose->x << ", " << pose->y << "); "
                                                 << explorer_.inspections().size() << " poses wait");
}

/// They were places on the map of before. [MAP-5]
void FrontierExplorerAdapter::leaveMap(const std::string& why) {
  const std::size_t waiting = explorer_.inspections().size();
  explorer_.leaveMap();
  tellAtOnce();
  if (waiting > 0) THROTTLED_WARN(waiting << " poses are not inspected any more: " << why);
}

void FrontierExplorerAdapter::handleReplaced(const std_msgs::String& msg) {
  leaveMap(msg.data);
  tick();  // so that no goal is sent in between that was chosen on the old map
}

bool FrontierExplorerAdapter::handleClearInspections(std_srvs::Trigger::Request&,
                                                     std_srvs::Trigger::Response& response) {
  const std::size_t waiting = explorer_.inspections().size();
  explorer_.clearInspections();
  tellAtOnce();
  tick();  // so that a goal to one of them is cancelled before the caller is answered
  response.success = 1U;
  response.message = waiting == 0
                         ? "nothing waits to be inspected: nothing changed"
                         : "poses that need not be inspected any more: " + std::to_string(waiting) + fromWhen();
  return true;
}

void FrontierExplorerAdapter::addInspections(ExplorerStatus& msg) const {
  for (const Pose2& pose : explorer_.inspections()) msg.to_inspect.push_back(toPoseMsg(pose));
}

}  // namespace frontier_pilot
