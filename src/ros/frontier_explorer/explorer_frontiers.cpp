#include <ros/this_node.h>

#include <vector>

#include "ros/frontier_explorer/explorer_markers.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"

/// The frontiers in the status of the explorer, and as markers. [EXP-9]
namespace frontier_pilot {
namespace {

constexpr std::size_t kMost = 100;  // more would only make the message long

geometry_msgs::Point toPointMsg(const Vec2& point) {
  geometry_msgs::Point msg;
  msg.x = point.x();
  msg.y = point.y();
  return msg;
}

FrontierStatus toFrontierMsg(const exploration::Frontier& frontier) {
  FrontierStatus msg;
  msg.centroid = toPointMsg(frontier.centroid);
  msg.goal = toPointMsg(frontier.goal);
  msg.cells = static_cast<std::uint32_t>(frontier.cell_count);
  msg.gain = frontier.info.area;
  msg.distance = frontier.distance;
  msg.cost = frontier.cost;
  msg.place = static_cast<std::uint32_t>(frontier.place);
  if (frontier.place > 0) msg.owner = ros::this_node::getNamespace();
  if (!frontier.selectable()) msg.reason = toString(frontier.rejection);
  return msg;
}

/// Of frontiers that are too small or left out there can be thousands.
bool isOneOfMany(const exploration::Frontier& frontier) {
  using exploration::Rejection;
  return frontier.rejection == Rejection::kTooSmall || frontier.rejection == Rejection::kLeftOut;
}

}  // namespace

/// Those that can be chosen come first.
void FrontierExplorerAdapter::addFrontiers(ExplorerStatus& msg) const {
  for (const bool selectable : {true, false}) {
    for (const exploration::Frontier& frontier : explorer_.frontiers()) {
      if (frontier.selectable() != selectable || isOneOfMany(frontier)) continue;
      if (msg.frontiers.size() >= kMost) return;
      msg.frontiers.push_back(toFrontierMsg(frontier));
    }
  }
}

void FrontierExplorerAdapter::showFrontiers(bool news, Time now) {
  markers_due_ = markers_due_ || news;
  if (!markers_due_ || markers_publisher_.getNumSubscribers() == 0) return;
  markers_due_ = false;
  const ExplorerScene scene{explorer_.frontiersWithCells(),
                            explorer_.geometry(),
                            explorer_.blacklist(),
                            explorer_.bounds(),
                            explorer_.tour(),
                            clicked_.corners(),
                            explorer_.inspections(),
                            ros::this_node::getNamespace()};
  markers_publisher_.publish(makeExplorerMarkers(scene, parameters_.map_frame, now));
}

}  // namespace frontier_pilot
