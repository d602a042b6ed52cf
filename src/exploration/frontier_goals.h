#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "exploration/frontier_search.h"
#include "exploration/observed_map.h"
#include "exploration/travel/travel_field.h"
#include "frontier_pilot/exploration/frontier.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// A cell from which a frontier can be looked at, or the reason why there is none.
struct GoalCell {
  Cell cell;
  Rejection rejection = Rejection::kUnreachable;
  double obstacle_density = 0.0;
};

/// Finds the cells from which frontiers are looked at. Most frontiers do not change from one decision to the next, so
/// goals are kept, and so is that a frontier has none. [EXP-3] [EXP-5]
class FrontierGoals {
 public:
  /// All four are only read, and must live as long as this object.
  FrontierGoals(const FrontierParameters& parameters, const ObservedMap& map, const FrontierClusters& clusters,
                const TravelField& travel)
      : parameters_(parameters), map_(map), clusters_(clusters), travel_(travel) {}

  /// Forgets everything, for a map with another geometry.
  void restart();
  /// Forgets which frontiers have no goal, because the filters are others now.
  void forgetFailures() { failures_.clear(); }
  /// To be called when `travel` has been computed anew, from `from` through `space`.
  void setTravel(const TraversableSpace& space, Cell from) {
    space_ = &space;
    from_ = from;
  }

  /// If no suitable cell sees the anchor, for example in a corner, a few other cells of the cluster are tried as
  /// targets, the first and the last of them too: a strip seen through a door can only be seen better from the door.
  GoalCell find(const FrontierCluster& cluster, Cell anchor);
  /// Whether a goal at `cell`, which can be reached, passes the filters that depend on the map alone.
  GoalCell judge(Cell cell) const;
  /// Offsets of the cells within goal_search_radius, nearest first.
  const std::vector<Cell>& offsets() const { return offsets_; }

 private:
  /// What the failure to find a goal depends on. Cells are reached or not as a whole region, so that their number
  /// almost always tells whether they are the same ones as before.
  struct Surroundings {
    const TraversableSpace* space = nullptr;
    CellRect cluster;
    std::uint64_t changes = 0;  ///< of the map
    std::size_t reached = 0;    ///< cells that can be reached
    bool operator==(const Surroundings& other) const {
      return space == other.space && cluster == other.cluster && changes == other.changes && reached == other.reached;
    }
  };
  struct Failure {
    Surroundings surroundings;
    GoalCell goal;
  };

  GoalCell search(const FrontierCluster& cluster, Cell anchor) const;
  GoalCell searchFor(Cell target) const;
  std::optional<GoalCell> recall(Cell anchor) const;
  std::optional<Surroundings> surroundingsOf(const FrontierCluster& cluster) const;

  const FrontierParameters& parameters_;
  const ObservedMap& map_;
  const FrontierClusters& clusters_;
  const TravelField& travel_;
  const TraversableSpace* space_ = nullptr;
  Cell from_;
  std::vector<Cell> offsets_;
  std::unordered_map<std::size_t, Cell> goals_;        ///< the last goal found, by the index of the frontier's anchor
  std::unordered_map<std::size_t, Failure> failures_;  ///< by the same index
};

}  // namespace frontier_pilot::exploration
