#include "ros/navigator/navigator_publisher.h"

#include <frontier_pilot/NavigatorProgress.h>
#include <nav_msgs/Path.h>
#include <std_msgs/String.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr double kLocalPeriod = 0.5;     // [s]
constexpr double kGlobalPeriod = 2.0;    // [s]
constexpr double kLocalReach = 3.0;      // [m]
constexpr double kPlanSpacing = 0.1;     // [m]
constexpr double kProgressPeriod = 0.5;  // [s]
constexpr double kNoPath = std::numeric_limits<double>::quiet_NaN();

/// Whether it is time to publish again; also true after the clock has gone back.
bool due(std::optional<Time>& last, Time now, double period) {
  if (last && now >= *last && toSeconds(now - *last) < period) return false;
  last = now;
  return true;
}

std::int8_t cost(const planning::ClearanceMap& map, Cell cell) {
  if (map.isOccupied(cell)) return kOccupied;
  if (map.isUnknown(cell)) return kUnknown;
  const std::uint8_t cost_class = map.costClass(cell);
  if (cost_class == 0) return 99;
  const double nearness = (map.weight(cost_class) - 1.0) / std::max(1e-6, map.weight(1) - 1.0);
  // A tight cell weighs more than the nearest free one, but is no obstacle.
  return static_cast<std::int8_t>(std::lround(98.0 * std::min(1.0, nearness)));
}

}  // namespace

std::vector<Pose2> withYaw(const std::vector<Vec2>& points) {
  std::vector<Pose2> poses;
  double yaw = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i + 1 < points.size()) yaw = bearing(points[i + 1] - points[i]);
    poses.emplace_back(points[i], yaw);
  }
  return poses;
}

OccupancyGrid costmap(const planning::ClearanceMap& map, const CellRect& rect) {
  const CellRect cells = rect.intersection(map.geometry().rect());
  GridGeometry geometry = map.geometry();
  geometry.origin += geometry.resolution * Vec2(cells.x, cells.y);
  geometry.width = cells.width;
  geometry.height = cells.height;
  OccupancyGrid grid(geometry);
  for (int y = 0; y < cells.height; ++y) {
    for (int x = 0; x < cells.width; ++x) grid[Cell{x, y}] = cost(map, {cells.x + x, cells.y + y});
  }
  return grid;
}

NavigatorPublisher::NavigatorPublisher(ros::NodeHandle& node, std::string map_frame, double max_linear)
    : map_frame_(std::move(map_frame)),
      max_linear_(max_linear),
      plan_(node.advertise<nav_msgs::Path>(names::kPlan, 1, true)),
      local_plan_(node.advertise<nav_msgs::Path>(names::kLocalPlan, 1)),
      local_costmap_(node.advertise<nav_msgs::OccupancyGrid>(names::kLocalCostmap, 1)),
      global_costmap_(node.advertise<nav_msgs::OccupancyGrid>(names::kGlobalCostmap, 1)),
      status_publisher_(node.advertise<std_msgs::String>(names::kNavigatorStatus, 10, true)),
      progress_(node.advertise<NavigatorProgress>(names::kNavigatorProgress, 10, true)) {}

void NavigatorPublisher::publish(const navigation::Navigator& navigator, const navigation::NavigatorOutput& output,
                                 const std::optional<Pose2>& goal, const std::optional<Pose2>& T_map_base, Time now) {
  const bool is_news = publishStatus(output) || !(goal == told_goal_);
  if (is_news || (goal && due(progress_published_, now, kProgressPeriod))) publishProgress(navigator, goal, now);
  if (output.plan_changed) {
    const auto points = navigator.hasPath() ? navigator.path().sampled(kPlanSpacing) : std::vector<Vec2>();
    plan_.publish(toPathMsg(withYaw(points), map_frame_, now));
  }
  if (output.state == navigation::NavState::kDriving && local_plan_.getNumSubscribers() > 0) {
    local_plan_.publish(toPathMsg(withYaw(navigator.prediction()), map_frame_, now));
  }
  if (!navigator.clearanceMap().empty()) publishCostmaps(navigator.clearanceMap(), T_map_base, now);
}

void NavigatorPublisher::publishProgress(const navigation::Navigator& navigator, const std::optional<Pose2>& goal,
                                         Time now) {
  constexpr double kShareOfMaximum = 0.9;
  told_goal_ = goal;
  NavigatorProgress msg;
  msg.header.frame_id = map_frame_;
  msg.header.stamp = toRosTime(now);
  msg.has_goal = goal ? 1 : 0;
  msg.goal = toPoseMsg(goal.value_or(Pose2()));
  const bool has_path = goal && navigator.hasPath();
  msg.distance_left = has_path ? std::max(0.0, navigator.path().length() - navigator.progress()) : kNoPath;
  msg.time_left = msg.distance_left / (kShareOfMaximum * max_linear_);
  msg.status = status_;
  progress_.publish(msg);
}

bool NavigatorPublisher::publishStatus(const navigation::NavigatorOutput& output) {
  std::string text = toString(output.state);
  if (!output.recovery.empty()) text += " (" + output.recovery + ")";
  text += std::string(": ") + toString(output.reason);
  if (!output.traffic.empty()) text += " (" + output.traffic + ")";
  // In IDLE the reason for which the last goal ended stays until the next change.
  if (text == status_ || (output.state == navigation::NavState::kIdle && output.finished.empty() && !status_.empty()))
    return false;
  status_ = text;
  THROTTLED_INFO(status_);
  std_msgs::String msg;
  msg.data = status_;
  status_publisher_.publish(msg);
  return true;
}

void NavigatorPublisher::publishCostmaps(const planning::ClearanceMap& map, const std::optional<Pose2>& T_map_base,
                                         Time now) {
  if (T_map_base && local_costmap_.getNumSubscribers() > 0 && due(local_published_, now, kLocalPeriod)) {
    const Cell centre = map.geometry().cellAt(T_map_base->position());
    const int reach = static_cast<int>(kLocalReach / map.geometry().resolution);
    const CellRect rect = CellRect{centre.x, centre.y, 1, 1}.grown(reach);
    local_costmap_.publish(toOccupancyGridMsg(costmap(map, rect), map_frame_, now));
  }
  if (global_costmap_.getNumSubscribers() > 0 && due(global_published_, now, kGlobalPeriod)) {
    global_costmap_.publish(toOccupancyGridMsg(costmap(map, map.geometry().rect()), map_frame_, now));
  }
}

}  // namespace frontier_pilot
