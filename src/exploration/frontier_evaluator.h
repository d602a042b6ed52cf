#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "exploration/frontier_search.h"
#include "exploration/goal_history.h"
#include "exploration/goal_score.h"
#include "exploration/observed_map.h"
#include "exploration/travel_field.h"
#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/frontier.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// From the map to judged frontiers: search, goals, filters, information. Holds what is worth keeping between
/// decisions, so that one costs the changed block, one wavefront, and views near the change.
class FrontierEvaluator {
 public:
  /// The ways to goals leave `clearance_margin` beside a robot of the outline `driven`.
  FrontierEvaluator(const FrontierParameters& parameters, const Outline& driven);

  /// Takes over a map; the block says where it may differ from the last one. Gives whether any cell changed class.
  bool setMap(const OccupancyGrid& map, const CellRect& changed);
  void setPlan(PlanFn plan) { plan_ = std::move(plan); }

  /// What the judgement depends on besides the map.
  struct Context {
    Vec2 robot = Vec2::Zero();  ///< in the map's frame [m]
    Vec2 start = Vec2::Zero();  ///< where it was first [m]
    const GoalHistory* history = nullptr;
    double least_density = 0.0;  ///< of information, of selectable frontiers; 0 for all
  };
  /// Finds every frontier of the map and judges it: its goal, or the reason why it has none. Ways to goals keep clear
  /// of unknown ground and have room to turn right round: a gap whose sides have yet to be seen may prove too narrow
  /// when the robot is in it. Gives whether any frontier can be selected.
  bool evaluate(const Context& context);
  /// Judges the same frontiers by ways through gaps that only just fit as well.
  bool evaluateTightWays(const Context& context);
  /// Judges them by such ways from `context.start`, if the robot is cut off from there by the last evaluation.
  bool evaluateWaysFromStart(const Context& context);

  /// The selectable ones of the last evaluation, scored, as the choice wants them.
  std::vector<GoalCandidate> candidates(const Vec2& robot);
  /// The same for a place that a goal was sent to before, which belongs to no frontier; none if it cannot be reached.
  std::optional<GoalCandidate> candidateAt(const Vec2& goal, const Vec2& robot);

  /// Blacklisted frontiers that can be reached without squeezing through gaps that only just fit. What lies behind such
  /// a gap, and the navigation could not get to, is not within reach.
  bool anyBlacklistedInTheOpen() const { return blacklisted_in_the_open_; }
  /// Frontiers within reach that the last evaluation did not judge, for there were too many. [FLT-1]
  std::size_t leftOut() const { return left_out_; }
  /// Whether the map has so many that it gave up before it looked for any. [FLT-1]
  bool tooMany() const { return clusters_.too_many; }
  /// Whether no frontier has been passed over for one of these two reasons.
  bool allJudged() const { return left_out_ == 0 && !clusters_.too_many; }
  /// Whether the last evaluation found ground for the robot to move on.
  bool robotHasGround() const { return travel_.reachedCount() > 0; }
  /// A reachable place a little farther than min_distance from the robot, from where what is too near now is not.
  std::optional<Vec2> placeToStepBackTo(const Vec2& robot) const;
  /// What a goal has to show at least [m^2]: leftovers count less in a large building.
  double leastInfo() const;
  /// What a place is expected to show now. [EXP-6]
  ViewGain infoAt(const Vec2& goal);
  const ObservedMap& map() const { return map_; }
  const std::vector<Frontier>& frontiers() const { return frontiers_; }
  /// Fills in the cells of every frontier of the last evaluation, for display.
  void listCells();

 private:
  struct GoalCell {
    Cell cell;
    Rejection rejection = Rejection::kUnreachable;
    double obstacle_density = 0.0;
  };
  struct CachedView {
    std::uint64_t changes = 0;
    ViewGain gain;
  };

  bool judgeAll(const TraversableSpace& space, const Vec2& from, const Context& context);
  Frontier outline(const FrontierCluster& cluster) const;
  void leaveOutAllBut(std::size_t most, const Vec2& robot);
  void judge(Frontier& frontier, const FrontierCluster& cluster, const Context& context);
  GoalCell findGoal(const FrontierCluster& cluster, Cell anchor);
  std::optional<GoalCell> recallGoal(Cell anchor) const;
  GoalCell findGoalFor(Cell target) const;
  GoalCell judgeGoal(Cell cell) const;
  void adoptGoal(Frontier& frontier, const GoalCell& goal, const Context& context);
  Rejection judgeView(Frontier& frontier, const Context& context);
  ViewGain cachedView(Cell cell);

  FrontierParameters parameters_;
  PlanFn plan_;
  ObservedMap map_;
  FrontierSearch search_;
  TraversableSpace space_;        ///< clear of unknown cells
  TraversableSpace tight_space_;  ///< clear of obstacles only; brought up to date when it is needed
  CellRect tight_changes_;        ///< what it has not heard of
  TravelField travel_;
  FrontierClusters clusters_;
  std::vector<Frontier> frontiers_;
  std::size_t left_out_ = 0;
  bool blacklisted_in_the_open_ = false;
  std::vector<Cell> rings_;  ///< offsets within goal_search_radius, nearest first
  std::unordered_map<std::size_t, CachedView> views_;
  std::unordered_map<std::size_t, Cell> goals_;  ///< found for an anchor before
};

}  // namespace frontier_pilot::exploration
