#pragma once

#include <memory>
#include <optional>
#include <string>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/planning/clearance_map.h"
#include "frontier_pilot/planning/outline_check.h"
#include "frontier_pilot/planning/path.h"

namespace frontier_pilot::planning {

struct GlobalPlannerParams {
  std::string algorithm = "any_angle_grid";  ///< or "rrt_connect", neither complete nor optimal
  double goal_tolerance = 0.4;               ///< how far a goal on an impassable cell may be moved [m]
  double escape_radius = 0.5;                ///< radius in which a blocked robot looks for a passable cell [m]
  int max_iterations = 20000;                ///< of a sampling planner

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("algorithm", algorithm, "", "any_angle_grid (complete), or rrt_connect (for comparison)");
    v.field("goal_tolerance", goal_tolerance, "m", "a goal in an inflated or unknown cell is moved by at most this",
            between(0.0, 5.0));
    v.fixed({"escape_radius", "max_iterations"});
  }
  void check(Problems& problems) const;
};

/// How planning ended.
enum class PlanStatus {
  kFound,
  kNoMap,
  kInvalidRequest,   ///< start or goal is not finite
  kStartOutside,     ///< of the map
  kStartBlocked,     ///< no passable cell within the escape radius, or no room to turn towards the goal
  kGoalOutside,      ///< of the map
  kGoalOccupied,     ///< in or too near an obstacle, and nothing reachable within the tolerance
  kGoalUnreachable,  ///< in unknown space, and nothing reachable within the tolerance
  kNoPath,           ///< the goal is passable but cannot be reached from the start
};
const char* toString(PlanStatus status);

/// Start and goal in the map frame [m].
struct PlanRequest {
  Vec2 start = Vec2::Zero();
  Vec2 goal = Vec2::Zero();
  double goal_tolerance = -1.0;                    ///< [m]; the parameter's value if negative
  std::optional<double> start_yaw = std::nullopt;  ///< [rad]; of a robot that needs room to turn
  bool quick = false;  ///< leave out the OrientedSearch, which may take seconds: the wheels turn meanwhile
};

struct PlanResult {
  PlanStatus status = PlanStatus::kNoMap;
  Path path;                 ///< from the start to the goal, or as near to it as was possible; empty unless kFound
  std::size_t escape = 0;    ///< number of first segments that lead out of the inflation and need not be valid
  std::size_t expanded = 0;  ///< number of cells or states that were expanded
  bool postponed = false;    ///< a quick request that only an OrientedSearch could answer; there is no path

  bool found() const { return status == PlanStatus::kFound; }
};

/// Global planner: OMPL's state space, validity checking and problem definition in R^2, on the ClearanceMap, with a
/// planner of our own that is complete on the grid and deterministic. If the outline of a robot that is not a disc
/// cannot turn on the shortest path for its lane, an OrientedSearch looks for one that it can follow. The same request
/// on the same map gives the same path.
class GlobalPlanner {
 public:
  explicit GlobalPlanner(const GlobalPlannerParams& params = {}, const OutlineCheck& outline = {});
  ~GlobalPlanner();
  GlobalPlanner(GlobalPlanner&&) noexcept;
  GlobalPlanner& operator=(GlobalPlanner&&) noexcept;
  GlobalPlanner(const GlobalPlanner&) = delete;
  GlobalPlanner& operator=(const GlobalPlanner&) = delete;

  /// `map` must be refreshed. Every segment of a found path after the escape is valid on the map, and the outline can
  /// follow it.
  PlanResult plan(const ClearanceMap& map, const PlanRequest& request);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Whether the path is still valid from `from` [m along it] on; its first `escape` segments are exempt.
bool isPathValid(const ClearanceMap& map, const Path& path, std::size_t escape, double from = 0.0);

}  // namespace frontier_pilot::planning
