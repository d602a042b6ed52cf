#include <cstdio>

#include "exploration/tour/tour_strategy.h"

#include <algorithm>

namespace frontier_pilot::exploration {

ChosenGoal TourStrategy::goalAt(const Pose2& pose) const {
  ChosenGoal goal;
  goal.position = pose.position();
  goal.yaw = pose.yaw;
  goal.distance = evaluator_->travel().distance(evaluator_->map().geometry().cellAt(goal.position));
  goal.area = evaluator_->infoAt(pose).area;
  goal.why = "nearly reached";
  return goal;
}

ChosenGoal TourStrategy::goalOf(const Plan& plan, const Situation& situation) {
  const Viewpoint& viewpoint = viewpoints_[plan.stops.front().viewpoint];
  const GridGeometry& geometry = evaluator_->map().geometry();
  // On the way to the same place the yaw stays as it is, as long as it will do.
  const bool is_present = situation.current && geometry.cellAt(situation.current->position()) == viewpoint.cell;
  const double wanted = is_present ? situation.current->yaw : arrivalYaw(viewpoint.cell);
  ChosenGoal goal = goalAt({geometry.centre(viewpoint.cell), nearestYaw(viewpoint.look, wanted)});
  aimed_at_.clear();
  for (const Sight& sight : viewpoint.sights) {
    aimed_at_.push_back(geometry.centre(evaluator_->frontiers()[sight.frontier].anchor));
  }
  std::size_t frontiers = 0;
  for (std::size_t place = 0; place < plan.stops.size(); ++place) {
    goal.tour.push_back(geometry.centre(viewpoints_[plan.stops[place].viewpoint].cell));
    for (const std::size_t frontier : plan.stops[place].frontiers) {
      evaluator_->setPlace(frontier, static_cast<int>(place) + 1, plan.stops[place].arrival);
    }
    frontiers += plan.stops[place].frontiers.size();
  }
  char text[120];
  std::snprintf(text, sizeof text, "first of %zu stops that show %zu frontiers in about %.0f s", plan.stops.size(),
                frontiers, plan.cost);
  goal.why = text;
  return goal;
}

/// The direction in which the way arrives at a viewpoint, so that the robot need not turn there [rad].
double TourStrategy::arrivalYaw(Cell goal) const {
  constexpr double kLookBack = 0.5;  // [m]
  const TravelField& travel = evaluator_->travel();
  const GridGeometry& geometry = travel.geometry();
  Cell at = goal;
  while ((geometry.centre(at) - geometry.centre(goal)).norm() < kLookBack) {
    const Cell next = nextTowardsOrigin(travel, at);
    if (next == at) break;
    at = next;
  }
  return at == goal ? robot_.yaw : bearing(geometry.centre(goal) - geometry.centre(at));
}

Pose2 TourStrategy::poseAt(std::size_t viewpoint) const {
  return {evaluator_->map().geometry().centre(viewpoints_[viewpoint].cell), viewpoints_[viewpoint].look.yaw};
}

/// How long the robot, on a straight way from `before`, turns at a viewpoint until its scanner sees what the viewpoint
/// shows [s].
double TourStrategy::secondsToLookFrom(std::size_t viewpoint, const Pose2& before) const {
  constexpr double kSamePlace = 0.1;  // [m]
  const Look& look = viewpoints_[viewpoint].look;
  if (look.slack >= kPi) return 0.0;
  const Vec2 way = poseAt(viewpoint).position() - before.position();
  const double arriving = way.norm() < kSamePlace ? before.yaw : bearing(way);
  return std::abs(angleDifference(nearestYaw(look, arriving), arriving)) / limits_.max_angular;
}

/// The viewpoint being driven to, if it still shows enough of a frontier that is not left to another robot.
std::optional<std::size_t> TourStrategy::presentViewpoint(const Situation& situation) const {
  if (!situation.current) return std::nullopt;
  const Cell cell = evaluator_->map().geometry().cellAt(situation.current->position());
  for (std::size_t v = 0; v < viewpoints_.size(); ++v) {
    if (viewpoints_[v].cell != cell) continue;
    const std::vector<Sight>& sights = viewpoints_[v].sights;
    const bool is_ours = std::any_of(sights.begin(), sights.end(), [&](const Sight& s) { return !left_[s.frontier]; });
    return is_ours ? std::make_optional(v) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace frontier_pilot::exploration
