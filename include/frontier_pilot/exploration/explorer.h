#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/frontier.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// Frontier exploration as a state machine: chooses where to look next until no reachable frontier is left. Goals go to
/// whatever navigation the caller has. Deterministic. [EXP-1] to [EXP-8]
/// Yamauchi, "A Frontier-Based Approach for Autonomous Exploration", CIRA 1997.
class Explorer {
 public:
  explicit Explorer(const ExplorerParameters& parameters = {});
  ~Explorer();
  Explorer(Explorer&&) noexcept;
  Explorer& operator=(Explorer&&) noexcept;
  Explorer(const Explorer&) = delete;
  Explorer& operator=(const Explorer&) = delete;

  /// The map, whenever it changes; `changed` holds every cell that may differ from last time.
  void setMap(const OccupancyGrid& map, const CellRect& changed);
  /// Asks a planner, in place of the own wavefront, for travel distances.
  void setPlan(PlanFn plan);

  ExplorerOutput update(const ExplorerInputs& inputs, Time now);

  /// As judged at the last decision.
  const std::vector<Frontier>& frontiers() const;
  /// The same with their cells listed, for display.
  const std::vector<Frontier>& frontiersWithCells();
  /// Of the map that `Frontier::cells` are cells of.
  const GridGeometry& geometry() const;
  const std::vector<BlacklistedPlace>& blacklist() const;
  /// The goal that the navigation has, or had until it was reached; in the map's frame.
  const std::optional<Pose2>& goal() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::exploration
