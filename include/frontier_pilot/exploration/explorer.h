#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/frontier.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// Frontier exploration as a state machine: chooses goals until no reachable frontier is left; the caller passes them
/// to its navigation. Deterministic. [EXP-1] to [EXP-8], [EXP-10], [EXP-11]
/// Yamauchi, "A Frontier-Based Approach for Autonomous Exploration", CIRA 1997.
class Explorer {
 public:
  explicit Explorer(const ExplorerParameters& parameters = {});
  ~Explorer();
  Explorer(Explorer&&) noexcept;
  Explorer& operator=(Explorer&&) noexcept;
  Explorer(const Explorer&) = delete;
  Explorer& operator=(const Explorer&) = delete;

  /// To be called whenever the map changes; `changed` covers every cell that may differ from the previous map.
  void setMap(const OccupancyGrid& map, const CellRect& changed);
  /// Replaces the bounds, which at first are those of the parameters. They have to be free of problems. `map` is the
  /// present map; it may be empty if there is none yet. [EXP-10]
  void setBounds(const ExplorationBounds& bounds, const OccupancyGrid& map);
  const ExplorationBounds& bounds() const;
  /// Whether the robot is driven back to the start at the end, which at first is as the parameters say. A robot that is
  /// on its way back already is not stopped. [EXP-10]
  void setReturnToStart(bool on);
  bool returnsToStart() const;
  /// Where the exploration began, in the map's frame: where the robot was when it was first to explore, or what was
  /// set.
  const std::optional<Pose2>& start() const;
  /// To be called before the first update of an explorer that goes on with what another one has begun.
  void setStart(const Pose2& T_map_start);
  /// The stopping rule that has ended the exploration; nothing while none has, or once it was started again. [EXP-10]
  std::optional<ExplorerReason> endedBy() const;
  /// Takes over what may change while it runs: the filters of the frontiers, the weights of the score and the goals'
  /// timeout. Goals are judged by them from the next decision on, also if the map stays the same; an exploration that
  /// is done stays so until the map changes. Bounds and `return_to_start` stay as they are.
  void setParameters(const ExplorerParameters& parameters);
  /// `plan` gives the distance of each goal that the explorer's wavefront has found reachable; without a path the goal
  /// is unreachable.
  void setPlan(PlanFn plan);

  /// Asks for a pose, in the map's frame, to be taken when the detour on the way to a frontier is small, or else when
  /// nothing is left to explore. Returns why not, empty if it will be. [EXP-10]
  std::string inspect(const Pose2& pose);
  /// Takes all of that back.
  void clearInspections();
  /// Another map will come in the place of the present one: takes back the poses to inspect and the goal, and chooses
  /// the next goal some seconds later.
  void leaveMap();
  /// The poses that wait to be inspected.
  std::vector<Pose2> inspections() const;

  ExplorerOutput update(const ExplorerInputs& inputs, Time now);

  /// The frontiers as judged at the last decision.
  const std::vector<Frontier>& frontiers() const;
  /// The same with `Frontier::cells` filled in, for display.
  const std::vector<Frontier>& frontiersWithCells();
  /// Geometry of the map that `Frontier::cells` refer to.
  const GridGeometry& geometry() const;
  const std::vector<BlacklistedPlace>& blacklist() const;
  /// The goals that strategy `tour` planned at the last decision, in their order [m]; the first one is the present goal
  /// or the one that will replace it. Empty without a tour.
  const std::vector<Vec2>& tour() const;
  /// What the robot is going to look at, by the last decision, with the time that is left until then; empty when it
  /// does not explore. For the other robots of its team. [MUL-2]
  std::vector<Claim> claims() const;
  /// In words: why this goal and not another, what comes next, and why other frontiers are left out.
  std::string explain() const;
  /// The last goal sent, until it is cancelled or its outcome has been evaluated; in the map frame.
  const std::optional<Pose2>& goal() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::exploration
