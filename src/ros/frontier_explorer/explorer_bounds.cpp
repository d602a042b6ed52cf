#include "ros/frontier_explorer/explorer_bounds.h"
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
  const exploration::ExplorationBounds bounds = toBounds(request);
  const std::string problem = bounds.problem();
  response.success = static_cast<std::uint8_t>(problem.empty());
  response.message = problem.empty() ? bounds.describe() : problem + "; the bounds are as before";
  if (!problem.empty()) return true;
  explorer_.setBounds(bounds, map_.ready() ? map_.map() : OccupancyGrid());
  markers_due_ = true;
  last_status_.reset();
  tick();  // so that a goal that is outside now is cancelled before the call is answered
  if (status_.reason == exploration::ExplorerReason::kRobotOutOfBounds) {
    response.message += std::string("; ") + toString(status_.reason) + " and is not driven";
  }
  return true;
}

}  // namespace frontier_pilot
