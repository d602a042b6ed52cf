#include "exploration/tour/viewpoint_distances.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frontier_pilot::exploration {
namespace {

constexpr double kSlack = 1.2;  // paths over coarse cells may be longer than those over the map's

}  // namespace

CellRect ViewpointDistances::follow(FrontierEvaluator& evaluator) {
  const TraversableSpace& space = evaluator.space();
  const auto known =
      std::find_if(followed_.begin(), followed_.end(), [&](const Followed& f) { return f.space == &space; });
  judged_ = static_cast<std::size_t>(known - followed_.begin());
  if (known == followed_.end()) followed_.push_back({&space, {}});
  return followed_[judged_].coarse.update(space, evaluator.takeSpaceChanges());
}

void ViewpointDistances::restart(const std::vector<Viewpoint>& viewpoints, const FrontierEvaluator& evaluator) {
  places_.clear();
  cells_.clear();
  ways_.clear();
  for (const Viewpoint& viewpoint : viewpoints) {
    places_.push_back(evaluator.map().geometry().centre(viewpoint.cell));
    cells_.push_back(coarse().geometry().cellAt(places_.back()));
    ways_.push_back(evaluator.travel().distance(viewpoint.cell));
  }
  longest_way_ = ways_.empty() ? 0.0 : *std::max_element(ways_.begin(), ways_.end());
  rows_.assign(viewpoints.size(), {});
}

/// No way between two viewpoints is longer than that over the robot, but for the larger cells.
const std::vector<double>& ViewpointDistances::from(std::size_t viewpoint) {
  std::vector<double>& row = rows_[viewpoint];
  if (!row.empty()) return row;
  field_.compute(coarse().neighbours(), cells_[viewpoint], kSlack * (ways_[viewpoint] + longest_way_) + kSlack);
  for (std::size_t other = 0; other < cells_.size(); ++other) {
    const double distance = field_.distance(cells_[other]);
    row.push_back(std::isfinite(distance) ? distance : 2.0 * (places_[other] - places_[viewpoint]).norm());
  }
  return row;
}

std::vector<double> ViewpointDistances::to(const Vec2& place) {
  field_.compute(coarse().neighbours(), coarse().geometry().cellAt(place), std::numeric_limits<double>::infinity());
  std::vector<double> distances;
  for (const Cell cell : cells_) distances.push_back(field_.reached(cell) ? field_.distance(cell) : -1.0);
  return distances;
}

std::vector<double> ViewpointDistances::turnsFrom(const Pose2& T_map_robot) {
  field_.compute(coarse().neighbours(), coarse().geometry().cellAt(T_map_robot.position()),
                 kSlack * (longest_way_ + 1.0));
  std::vector<double> turns;
  for (const Cell cell : cells_) turns.push_back(turnTowards(cell, T_map_robot));
  return turns;
}

/// By the wavefront of the robot's own cell in `field_`.
double ViewpointDistances::turnTowards(Cell goal, const Pose2& T_map_robot) const {
  constexpr int kAhead = 5;  // [cells]: where the way is looked at
  const Cell robot = coarse().geometry().cellAt(T_map_robot.position());
  if (!field_.reached(goal)) return 0.0;
  Cell at = goal;
  while (std::max(std::abs(at.x - robot.x), std::abs(at.y - robot.y)) > kAhead) {
    const Cell next = nextTowardsOrigin(field_, at);
    if (next == at) break;
    at = next;
  }
  const Vec2 ahead = coarse().geometry().centre(at) - T_map_robot.position();
  if (ahead.norm() < coarse().geometry().resolution) return 0.0;
  return std::abs(angleDifference(bearing(ahead), T_map_robot.yaw));
}

}  // namespace frontier_pilot::exploration
