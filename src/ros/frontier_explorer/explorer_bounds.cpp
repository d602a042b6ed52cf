#include "ros/frontier_explorer/explorer_bounds.h"

#include "ros/common/clock.h"
#include "ros/common/messages/message_problems.h"
#include "ros/common/tf/frame_name.h"
#include "ros/common/throttled_log.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"

namespace frontier_pilot {
namespace {

std::vector<Vec2> toCorners(const geometry_msgs::Polygon& polygon) {
  std::vector<Vec2> corners;
  for (const geometry_msgs::Point32& point : polygon.points) corners.emplace_back(point.x, point.y);
  return corners;
}

}  // namespace

exploration::ExplorationBounds toBounds(const SetBounds::Request& request) {
  exploration::ExplorationBounds bounds;
  bounds.stay_within = toCorners(request.stay_within);
  for (const geometry_msgs::Polygon& area : request.keep_out) bounds.keep_out.push_back(toCorners(area));
  return bounds;
}

geometry_msgs::Polygon toPolygonMsg(const std::vector<Vec2>& corners) {
  geometry_msgs::Polygon polygon;
  for (const Vec2& corner : corners) {
    geometry_msgs::Point32 point;
    point.x = static_cast<float>(corner.x());
    point.y = static_cast<float>(corner.y());
    polygon.points.push_back(point);
  }
  return polygon;
}

bool FrontierExplorerAdapter::handleSetBounds(SetBounds::Request& request, SetBounds::Response& response) {
  clicked_.clear();
  const BoundsAnswer answer = takeBounds(toBounds(request));
  response.success = static_cast<std::uint8_t>(answer.taken);
  response.message = answer.message;
  return true;
}

bool FrontierExplorerAdapter::handleClearBounds(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  clicked_.clear();
  response.message = takeBounds({}).message;
  response.success = 1U;
  return true;
}

/// Puts new bounds into force, unless something is wrong with them, and says so.
FrontierExplorerAdapter::BoundsAnswer FrontierExplorerAdapter::takeBounds(
    const exploration::ExplorationBounds& bounds) {
  tellAtOnce();
  const std::string problem = bounds.problem();
  if (!problem.empty()) return {false, problem + "; the bounds are as before"};
  explorer_.setBounds(bounds, map_.ready() ? map_.map() : OccupancyGrid());
  tick();  // so that a goal that is outside now is cancelled before the caller is answered
  std::string message = bounds.describe() + memory_->keepBounds(bounds) + fromWhen();
  if (status_.reason == exploration::ExplorerReason::kRobotOutOfBounds) {
    message += std::string("; ") + toString(status_.reason) + " and is not driven";
  }
  return {true, message};
}

/// A click of rviz' Publish Point. [EXP-10]
void FrontierExplorerAdapter::handleClick(const geometry_msgs::PointStamped& msg) {
  std::string why;
  const auto at = inMapFrame(msg, why);
  if (!at) return bad_clicks_.add(why);
  const auto click = clicked_.add(*at, steadyNow());
  tellAtOnce();
  if (click == ClickedPolygon::Click::kTooMany) return bad_clicks_.add("the bounds have as many corners as they may");
  if (click == ClickedPolygon::Click::kClosed) return closePolygon();
  if (click == ClickedPolygon::Click::kSame) return;
  THROTTLED_INFO("corner " << clicked_.corners().size() << " of new bounds at (" << at->x() << ", " << at->y()
                           << "); a click within " << ClickedPolygon::kCloseDistance
                           << " m of the first corner closes them");
}

void FrontierExplorerAdapter::closePolygon() {
  exploration::ExplorationBounds bounds = explorer_.bounds();
  bounds.stay_within = clicked_.corners();
  clicked_.clear();
  const BoundsAnswer answer = takeBounds(bounds);
  if (answer.taken) THROTTLED_INFO("new bounds by clicks: " << answer.message);
  if (!answer.taken) THROTTLED_WARN("the clicks are refused: " << answer.message);
}

/// Drops a polygon that nobody has gone on with.
void FrontierExplorerAdapter::expireClicks() {
  if (!clicked_.expire(steadyNow())) return;
  tellAtOnce();
  THROTTLED_INFO("the corners clicked so far are dropped: no click for half a minute");
}

/// The point in the map's frame at its own stamp [m], or by the latest transform where TF does not reach that far;
/// without its height. `why` tells what is wrong if there is none. Nothing is waited for: clicks may come in a flood.
std::optional<Vec2> FrontierExplorerAdapter::inMapFrame(const geometry_msgs::PointStamped& msg,
                                                        std::string& why) const {
  why = problemOfPlace(msg.point.x, msg.point.y, msg.point.z);
  if (!why.empty()) return std::nullopt;
  const Eigen::Vector3d point(msg.point.x, msg.point.y, msg.point.z);
  if (isSameFrame(msg.header.frame_id, parameters_.map_frame)) return point.head<2>();
  const auto at = [&](Time stamp) {
    return tf_.lookup3d(parameters_.map_frame, msg.header.frame_id, stamp, Duration::zero(), &why);
  };
  auto T_map_frame = at(toTime(msg.header.stamp));
  if (!T_map_frame) T_map_frame = at(Time{});
  if (!T_map_frame) return std::nullopt;
  return (*T_map_frame * point).head<2>();
}

}  // namespace frontier_pilot
