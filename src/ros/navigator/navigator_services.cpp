#include "frontier_pilot/system/behavior_ladder.h"
#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/throttled_log.h"
#include "ros/navigator/navigator_adapter.h"

namespace frontier_pilot {

bool NavigatorAdapter::handlePlan(nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response) {
  takeMap();
  const auto in_map = [&](const geometry_msgs::PoseStamped& msg) -> std::optional<Vec2> {
    const auto T_map_frame = tf_.lookup(parameters_.map_frame, msg.header.frame_id, Time{});
    const auto given = toPose(msg.pose);
    if (!T_map_frame || !given) return std::nullopt;
    return *T_map_frame * given->position();
  };
  // As in move_base: without a frame, the start is the robot's position.
  const auto start = request.start.header.frame_id.empty() ? positionNow() : in_map(request.start);
  const auto goal = in_map(request.goal);
  response.plan.header.frame_id = parameters_.map_frame;
  if (!start || !goal) {
    THROTTLED_WARN("make_plan: start or goal is malformed or in an unknown frame");
    return false;
  }
  const double tolerance = request.tolerance > 0.0F ? static_cast<double>(request.tolerance) : -1.0;
  const planning::PlanResult result = navigator_.makePlan({*start, *goal, tolerance});
  if (!result.found()) THROTTLED_WARN("make_plan: " << toString(result.status));
  response.plan = toPathMsg(withYaw(result.path.sampled(0.1)), parameters_.map_frame, rosNow());
  return true;
}

void NavigatorAdapter::take(const NavigatorNodeParameters& changed) {
  navigator_.setParameters(changed, system::behaviorLadder(changed, changed.rate));
  publisher_.setMaxLinear(changed.robot.limits.max_linear);
}

bool NavigatorAdapter::handleClear(std_srvs::Empty::Request&, std_srvs::Empty::Response&) {
  navigator_.clearObstacles();
  return true;
}

void NavigatorAdapter::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  const bool is_hindered = state_ == navigation::NavState::kWaiting || state_ == navigation::NavState::kRecovering;
  status.summary(is_hindered ? DiagnosticStatus::WARN : DiagnosticStatus::OK, publisher_.status());
  if (!failure_.empty()) status.summary(DiagnosticStatus::WARN, "last goal aborted: " + failure_);
  if (!map_.ready()) status.summary(DiagnosticStatus::WARN, "no map yet");
  map_.rejections().report(status);
  scan_motion_.report(status);
  bad_scans_.report(status);
  bad_odometry_.report(status);
  server_.report(status);
  tf_.report(status);
}

}  // namespace frontier_pilot
