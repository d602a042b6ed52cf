#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include "frontier_pilot/planning/clearance_map.h"
#include "planning/corridor.h"
#include "planning/grid_search.h"

namespace frontier_pilot::planning {

/// The plane of a map as an OMPL space. Motions are checked exactly on the ClearanceMap instead of at discrete states:
/// OMPL's default of 1 % of the extent would step through walls. `map` must outlive it.
ompl::base::SpaceInformationPtr makeSpaceInformation(const ClearanceMap& map);

/// Conversion between OMPL states and points of the plane.
Vec2 pointOf(const ompl::base::State* state);
void setPoint(ompl::base::State* state, const Vec2& point);

/// An OMPL planner that is complete on the grid: A* from the first start state from which a goal state can be reached,
/// to the first goal state that can: in the corridor between them, and over the whole map if there is no path in it.
/// `expanded` counts the cells of all searches.
class AnyAngleGridPlanner : public ompl::base::Planner {
 public:
  AnyAngleGridPlanner(const ompl::base::SpaceInformationPtr& si, const ClearanceMap& map, Corridor& corridor,
                      GridSearch& search);

  /// Ignores the termination condition: the search is bounded by the cells of the map, and a time limit would make it
  /// non-deterministic.
  ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition& condition) override;
  std::size_t expanded() const { return expanded_; }

 private:
  bool searchFrom(Cell start, const std::vector<Cell>& goals);
  bool searchCorridor(Cell start, Cell goal);
  void addSolution(Cell goal);

  const ClearanceMap& map_;
  Corridor& corridor_;
  GridSearch& search_;
  std::size_t expanded_ = 0;
};

}  // namespace frontier_pilot::planning
