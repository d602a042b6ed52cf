#include "planning/ompl_planner.h"

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace frontier_pilot::planning {
namespace {

namespace ob = ompl::base;

/// A path may cost this part (1/50, 2 %) more than the blocks promised before another one is looked for.
constexpr std::uint32_t kToleratedPart = 50;

class ClearanceChecker : public ob::StateValidityChecker {
 public:
  ClearanceChecker(const ob::SpaceInformationPtr& si, const ClearanceMap& map)
      : ob::StateValidityChecker(si), map_(map) {}
  bool isValid(const ob::State* state) const override { return map_.isValid(pointOf(state)); }
  double clearance(const ob::State* state) const override { return map_.clearance(pointOf(state)); }

 private:
  const ClearanceMap& map_;
};

class ExactMotionValidator : public ob::MotionValidator {
 public:
  ExactMotionValidator(const ob::SpaceInformationPtr& si, const ClearanceMap& map)
      : ob::MotionValidator(si), map_(map) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return map_.isValid(pointOf(from), pointOf(to));
  }

  /// Also returns the last valid state, found by bisection.
  bool checkMotion(const ob::State* from, const ob::State* to, std::pair<ob::State*, double>& last) const override {
    const Vec2 a = pointOf(from);
    const Vec2 b = pointOf(to);
    if (map_.isValid(a, b)) return true;
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (low + high);
      (map_.isValid(a, a + middle * (b - a)) ? low : high) = middle;
    }
    last.second = low;
    if (last.first != nullptr) setPoint(last.first, a + low * (b - a));
    return false;
  }

 private:
  const ClearanceMap& map_;
};

}  // namespace

Vec2 pointOf(const ob::State* state) {
  const auto* point = state->as<ob::RealVectorStateSpace::StateType>();
  return {point->values[0], point->values[1]};
}

void setPoint(ob::State* state, const Vec2& point) {
  auto* values = state->as<ob::RealVectorStateSpace::StateType>();
  values->values[0] = point.x();
  values->values[1] = point.y();
}

ob::SpaceInformationPtr makeSpaceInformation(const ClearanceMap& map) {
  const GridGeometry& grid = map.geometry();
  ob::RealVectorBounds bounds(2);
  bounds.setLow(0, grid.origin.x());
  bounds.setLow(1, grid.origin.y());
  bounds.setHigh(0, grid.origin.x() + grid.resolution * grid.width);
  bounds.setHigh(1, grid.origin.y() + grid.resolution * grid.height);
  auto space = std::make_shared<ob::RealVectorStateSpace>(2);
  space->setBounds(bounds);
  auto si = std::make_shared<ob::SpaceInformation>(space);
  si->setStateValidityChecker(std::make_shared<ClearanceChecker>(si, map));
  si->setMotionValidator(std::make_shared<ExactMotionValidator>(si, map));
  si->setStateValidityCheckingResolution(0.5 * grid.resolution / space->getMaximumExtent());
  si->setup();
  return si;
}

AnyAngleGridPlanner::AnyAngleGridPlanner(const ob::SpaceInformationPtr& si, const ClearanceMap& map, Corridor& corridor,
                                         GridSearch& search)
    : ob::Planner(si, "AnyAngleGrid"), map_(map), corridor_(corridor), search_(search) {
  specs_.approximateSolutions = false;
  specs_.recognizedGoal = ob::GOAL_STATES;
}

ob::PlannerStatus AnyAngleGridPlanner::solve(const ob::PlannerTerminationCondition& /*condition*/) {
  checkValidity();
  expanded_ = 0;
  std::vector<Cell> goals;
  const auto* goal_states = pdef_->getGoal()->as<ob::GoalStates>();
  for (std::size_t i = 0; i < goal_states->getStateCount(); ++i) {
    goals.push_back(map_.geometry().cellAt(pointOf(goal_states->getState(static_cast<unsigned>(i)))));
  }
  std::vector<Cell> starts;
  for (unsigned i = 0; i < pdef_->getStartStateCount(); ++i) {
    starts.push_back(map_.geometry().cellAt(pointOf(pdef_->getStartState(i))));
  }
  while (!starts.empty()) {
    if (searchFrom(starts.front(), goals)) return ob::PlannerStatus::EXACT_SOLUTION;
    // The cells that the failed search reached form an island without a goal.
    const auto on_island = [this](Cell start) { return search_.reached(start); };
    starts.erase(std::remove_if(starts.begin(), starts.end(), on_island), starts.end());
  }
  return ob::PlannerStatus::TIMEOUT;
}

bool AnyAngleGridPlanner::searchFrom(Cell start, const std::vector<Cell>& goals) {
  if (searchCorridor(start, goals.front())) {
    addSolution(goals.front());
    return true;
  }
  // Only a search of the whole map can tell that there is no path, and which goals can be reached.
  search_.search(map_, start, goals.front());
  expanded_ += search_.expanded();
  for (const Cell goal : goals) {
    if (!search_.reached(goal)) continue;
    addSolution(goal);
    return true;
  }
  return false;
}

bool AnyAngleGridPlanner::searchCorridor(Cell start, Cell goal) {
  // Where the path costs clearly more than the blocks promised, as in a gap whose cells are tight, another one may be
  // cheaper: the corridor is widened once to all paths that the blocks promise to be.
  std::uint32_t least_bound = 0;
  for (int i = 0; i < 2; ++i) {
    if (!corridor_.find(map_, start, goal, least_bound)) return false;
    const bool found = search_.search(map_, corridor_.classes(), start, goal);
    expanded_ += search_.expanded();
    if (!found) return false;
    least_bound = search_.costTo(goal);
    if (least_bound <= corridor_.bound() + corridor_.bound() / kToleratedPart) break;
  }
  return true;
}

void AnyAngleGridPlanner::addSolution(Cell goal) {
  auto path = std::make_shared<ompl::geometric::PathGeometric>(si_);
  ob::State* state = si_->allocState();
  for (const Cell cell : search_.pathTo(goal)) {
    setPoint(state, map_.geometry().centre(cell));
    path->append(state);
  }
  si_->freeState(state);
  pdef_->addSolutionPath(path, false, 0.0, getName());
}

}  // namespace frontier_pilot::planning
