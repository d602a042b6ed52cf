#include "ros/teleop_gui/map_link.h"

#include <algorithm>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/tf/frame_name.h"

namespace frontier_pilot {
namespace {

constexpr double kPeriod = 0.2;  // of the views [s]
constexpr std::size_t kMostShownPoints = 20'000;

/// Those that are places, and of very many only every n-th. [FLT-1]
std::vector<Vec2> shownOf(const std::vector<geometry_msgs::Point>& points) {
  const std::size_t step = points.size() / kMostShownPoints + 1;
  std::vector<Vec2> shown;
  for (std::size_t i = 0; i < points.size(); i += step) {
    const Vec2 point(points[i].x, points[i].y);
    const bool is_place =
        bounds::isWithin(point.x(), bounds::kMostCoordinate) && bounds::isWithin(point.y(), bounds::kMostCoordinate);
    if (is_place) shown.push_back(point);
  }
  return shown;
}

/// The values of the cells of `rect` row by row.
std::vector<std::int8_t> cellsIn(const OccupancyGrid& map, const CellRect& rect) {
  std::vector<std::int8_t> cells;
  cells.reserve(static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height));
  for (int y = rect.y; y < rect.y + rect.height; ++y)
    cells.insert(cells.end(), map.row(y) + rect.x, map.row(y) + rect.x + rect.width);
  return cells;
}

}  // namespace

MapLink::MapLink(const ros::NodeHandle& node, const TfBridge& tf, std::string base_frame)
    : tf_(tf),
      base_frame_(std::move(base_frame)),
      node_(onQueue(node, queue_)),
      connections_(node_),
      spinner_(1, &queue_) {
  map_.subscribe(connections_, {}, {}, Need::kOptional);
  localization_.subscribe(connections_, Need::kOptional);
  connections_.subscribe(names::kMapReplaced, 1, &MapLink::handleReplaced, this);
  plan_subscriber_ = connections_.subscribe(names::kPlan, 1, &MapLink::handlePlan, this);
  goal_subscriber_ = connections_.subscribe(names::kNavigatorProgress, 1, &MapLink::handleProgress, this);
  frontiers_subscriber_ = connections_.subscribe(names::kFrontiers, 1, &MapLink::handleMarkers, this);
  for (const auto* subscriber : {&plan_subscriber_, &goal_subscriber_, &frontiers_subscriber_})
    connections_.master().watchPublishers(subscriber->getTopic());
  connections_.everySteady(ros::WallDuration(kPeriod), [this] { collect(); });
  spinner_.start();
}

MapLink::~MapLink() { spinner_.stop(); }

teleop::MapView MapLink::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return {std::exchange(view_.change, std::nullopt), view_.scene};
}

std::string MapLink::frame() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return view_.scene.frame;
}

void MapLink::handlePlan(const nav_msgs::Path& msg) {
  std::string why;
  const auto path = toPath(msg, &why);
  if (!path) return bad_plans_.add(why);
  plan_ = {msg.header.frame_id, {}};
  const std::size_t step = path->size() / kMostShownPoints + 1;
  for (std::size_t i = 0; i < path->size(); i += step) plan_.points.push_back((*path)[i].position());
}

void MapLink::handleProgress(const NavigatorProgress& msg) {
  goal_ = msg.has_goal != 0 ? toPose(msg.goal) : std::nullopt;
  goal_frame_ = msg.header.frame_id;
}

/// The explorer marks the cells of the frontiers that it may choose from as points in a namespace of their own.
void MapLink::handleMarkers(const visualization_msgs::MarkerArray& msg) {
  frontiers_ = {};
  for (const visualization_msgs::Marker& marker : msg.markers) {
    const bool are_cells = marker.type == visualization_msgs::Marker::POINTS && marker.ns == names::kFrontierCells;
    if (are_cells && marker.action == visualization_msgs::Marker::ADD)
      frontiers_ = {marker.header.frame_id, shownOf(marker.points)};
  }
}

void MapLink::collect() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (view_.change) return;  // the window is busy: what changes meanwhile is handed over together
  }
  forgetGone();
  if (map_.takeReplaced()) ++replaced_;
  teleop::MapView view{takeChange(), scene()};
  view.scene.problem = printable(view.scene.problem, bounds::kMostReason);  // frames in it may have any length
  const std::lock_guard<std::mutex> lock(mutex_);
  view_ = std::move(view);
}

void MapLink::forgetGone() {
  const MasterWatch& master = connections_.master();
  if (!master.mayReceive(plan_subscriber_)) plan_ = {};
  if (!master.mayReceive(goal_subscriber_)) goal_.reset();
  if (!master.mayReceive(frontiers_subscriber_)) frontiers_ = {};
}

std::optional<teleop::MapChange> MapLink::takeChange() {
  const CellRect rect = map_.takeChanged();
  if (rect.empty()) return std::nullopt;
  return teleop::MapChange{map_.map().geometry(), rect, cellsIn(map_.map(), rect)};
}

teleop::MapScene MapLink::scene() const {
  teleop::MapScene scene;
  scene.replaced = replaced_;
  if (!map_.ready()) {
    const std::string& refused = map_.rejections().last();
    scene.problem = !map_.published() ? "No map: nobody publishes " + node_.resolveName(names::kMap) + "."
                    : refused.empty() ? "No map has arrived yet."
                                      : "The map was refused: " + refused + ".";
    return scene;
  }
  scene.frame = map_.frame();
  scene.plan = inMap(plan_, "The plan", scene.problem);
  if (goal_) {
    const auto T_map_frame = toMap(goal_frame_, "The goal", scene.problem);
    if (T_map_frame) scene.goal = *T_map_frame * *goal_;
  }
  scene.frontier_cells = inMap(frontiers_, "The frontiers", scene.problem);
  std::string why;
  scene.T_map_base = tf_.lookup(scene.frame, base_frame_, Time{}, Duration::zero(), &why);
  if (!scene.T_map_base)
    scene.problem =
        "Where the robot is on the map is not known: no transform from '" + scene.frame + "' to '" + base_frame_ + "'.";
  if (!localization_.isLocalized())
    scene.problem =
        "The robot is not found on the map: give a pose in rviz, or call " + node_.resolveName(names::kLocalize) + ".";
  if (!map_.published()) scene.problem = "The map is no longer updated: its publisher is gone.";
  return scene;
}

/// The transform into the frame of the map; nothing, and why in `problem`, if it is not known.
std::optional<Pose2> MapLink::toMap(const std::string& frame, const char* what, std::string& problem) const {
  if (isSameFrame(frame, map_.frame())) return Pose2();
  auto T_map_frame = tf_.lookup(map_.frame(), frame, Time{});
  if (!T_map_frame) {
    problem = std::string(what) + " cannot be shown: no transform from '" + map_.frame() + "' to '" + frame + "'.";
  }
  return T_map_frame;
}

std::vector<Vec2> MapLink::inMap(const Places& places, const char* what, std::string& problem) const {
  if (places.points.empty()) return {};
  const auto T_map_places = toMap(places.frame, what, problem);
  if (!T_map_places) return {};
  std::vector<Vec2> points;
  points.reserve(places.points.size());
  for (const Vec2& point : places.points) points.push_back(*T_map_places * point);
  return points;
}

}  // namespace frontier_pilot
