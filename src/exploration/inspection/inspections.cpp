#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "exploration/explorer_impl.h"

namespace frontier_pilot::exploration {
namespace {

std::string describe(const Pose2& pose) {
  char text[80];
  std::snprintf(text, sizeof text, "(%.2f, %.2f, %.0f deg)", pose.x, pose.y, pose.yaw * 180.0 / M_PI);
  return text;
}

/// The reached cell nearest to `place` and not farther than kNear from it: the robot cannot stand close to a wall.
std::optional<Cell> standingPlace(const TravelField& travel, const Vec2& place) {
  constexpr double kNear = 0.5;  // [m]
  const GridGeometry& geometry = travel.geometry();
  if (travel.reachedCount() == 0) return std::nullopt;
  const Cell low = geometry.cellAt(place - Vec2(kNear, kNear)), high = geometry.cellAt(place + Vec2(kNear, kNear));
  std::optional<Cell> nearest;
  double least = kNear;
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) {
      const double distance = (geometry.centre({x, y}) - place).norm();
      if (distance >= least || !travel.reached({x, y})) continue;
      least = distance;
      nearest = Cell{x, y};
    }
  }
  return nearest;
}

}  // namespace

std::vector<Pose2> Explorer::Impl::inspections() const {
  std::vector<Pose2> poses;
  for (const Inspection& each : inspections_.waiting()) poses.push_back(each.pose);
  return poses;
}

std::string Explorer::Impl::inspect(const Pose2& pose) { return inspections_.add(pose); }

/// Takes back all that wait, also the one being driven to.
void Explorer::Impl::clearInspections() {
  inspections_.clear();
  inspections_cleared_ = true;
}

void Explorer::Impl::leaveMap() {
  inspections_.clear();
  map_replaced_ = true;
}

/// The waiting poses that the last evaluation found reachable, the nearest first.
std::vector<Explorer::Impl::ReachableInspection> Explorer::Impl::reachableInspections() const {
  std::vector<ReachableInspection> reachable;
  for (const Inspection& each : inspections_.waiting()) {
    const auto cell = standingPlace(evaluator_.travel(), each.pose.position());
    if (cell) reachable.push_back({each, *cell, evaluator_.travel().distance(*cell)});
  }
  std::stable_sort(reachable.begin(), reachable.end(),
                   [](const auto& a, const auto& b) { return a.distance < b.distance; });
  return reachable;
}

/// Sends the robot to the nearest pose over which the way to the goal `next` is at most inspect/detour longer. Returns
/// whether there is one.
bool Explorer::Impl::inspectOnTheWay(const ChosenGoal& next, Time now) {
  const std::vector<ReachableInspection> places = reachableInspections();
  if (places.empty()) return false;
  const double most = next.distance + parameters_.inspect.detour;
  const Cell goal = evaluator_.map().geometry().cellAt(next.position);
  onwards_.compute(evaluator_.space().neighbours(), goal, most);
  for (const ReachableInspection& place : places) {
    if (place.distance + onwards_.distance(place.cell) > most) continue;
    sendToInspection(place, now);
    return true;
  }
  return false;
}

/// Nothing is left to explore: sends the robot to the nearest pose. Gives up those that cannot be reached, since no
/// more of the map will be seen. Returns whether there is one to drive to.
bool Explorer::Impl::inspectWhatIsLeft(Time now) {
  if (inspections_.waiting().empty()) return false;
  const std::vector<ReachableInspection> reachable = reachableInspections();
  if (!reachable.empty()) {
    sendToInspection(reachable.front(), now);
    return true;
  }
  for (const Inspection& each : inspections_.waiting())
    note(true, "not inspected, no way leads to " + describe(each.pose));
  inspections_.giveUp();
  return false;
}

void Explorer::Impl::sendToInspection(const ReachableInspection& place, Time now) {
  Goal goal;
  goal.purpose = Goal::Purpose::kInspection;
  goal.inspection = place.inspection.id;
  goal.position = evaluator_.map().geometry().centre(place.cell);
  const std::string text = "to inspect " + describe(place.inspection.pose) + " on the way";
  goal.yaw = place.inspection.pose.yaw;
  send(goal, ExplorerReason::kInspecting, text, now);
}

/// Stands at the pose for the time asked for. Returns whether that is over.
bool Explorer::Impl::hasInspected(Time now) {
  if (now - state_since_ < fromSeconds(parameters_.inspect.stay)) return false;
  inspections_.done(arrived_->inspection);
  note(false, "inspected " + describe(*goal_pose_));
  return true;
}

/// A pose to which the navigation has failed twice is given up.
void Explorer::Impl::inspectionFailed(const Goal& goal, const std::string& what) {
  if (inspections_.failed(goal.inspection)) note(true, "not inspected: " + what);
}

/// Drops the goal to a pose that need not be inspected any more.
void Explorer::Impl::obeyClearedInspections(Time now) {
  if (!std::exchange(inspections_cleared_, false)) return;
  const auto inspects = [](const std::optional<Goal>& goal) {
    return goal && goal->purpose == Goal::Purpose::kInspection;
  };
  if (!inspects(goal_) && !inspects(arrived_)) return;
  cancelGoal();
  enter(ExplorerState::kSelectGoal, ExplorerReason::kInspectionsCleared, "", now);
}

}  // namespace frontier_pilot::exploration
