#pragma once

#include <vector>

#include "support/floor_plans/plan_random.h"
#include "support/tour/sight.h"
#include "support/tour/waypoint_graph.h"

namespace frontier_pilot::bench {

/// Searches a short way through a graph on whose waypoints enough of a floor is seen. A large neighbourhood search
/// (Shaw, "Using Constraint Programming and Local Search Methods to Solve Vehicle Routing Problems", CP 1998): in each
/// round some stops are taken out, and others are inserted where they show most per metre of detour, until enough is
/// seen; then the order is improved by 2-opt (Croes, Operations Research 6, 1958) and Or-opt (Or, Northwestern
/// University, 1976). It starts from no stop at all.
class TourSearch {
 public:
  /// `views`: what is seen from each waypoint. `needed`: the least number of cells to be seen.
  TourSearch(const WaypointGraph& graph, const std::vector<View>& views, const FloorBits& floor, int needed);

  /// The waypoints of the best way found, from the first waypoint on. Deterministic.
  std::vector<int> run(int rounds);

 private:
  using Stops = std::vector<int>;  ///< the first is the start

  double length(const Stops& stops) const;
  std::vector<int> wayThrough(const Stops& stops) const;
  FloorBits::Bits missing(const Stops& stops) const;
  /// How many cells are still to be seen.
  int lack(const FloorBits::Bits& missing) const;
  bool seesEnough(const Stops& stops) const { return lack(missing(stops)) <= 0; }

  struct Insertion {
    int node = -1;
    std::size_t before = 0;  ///< the number of the stop
    double detour = 0.0;     ///< [m]
  };
  Insertion cheapest(const Stops& stops, const std::vector<double>& legs, int node) const;
  Insertion bestInsertion(const Stops& stops, const FloorBits::Bits& missing, int lack);
  void repair(Stops& stops);
  Stops destroyed(const Stops& stops);
  void prune(Stops& stops) const;

  const WaypointGraph& graph_;
  const std::vector<View>& views_;
  const FloorBits& floor_;
  int needed_;
  PlanRandom random_{1};
};

}  // namespace frontier_pilot::bench
