#pragma once

#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "exploration/frontier_goals.h"
#include "exploration/frontier_search.h"
#include "exploration/goal_score.h"
#include "exploration/history/goal_history.h"
#include "exploration/limits/way_inside.h"
#include "exploration/observed_map.h"
#include "exploration/team/shared_work.h"
#include "exploration/travel/travel_field.h"
#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/frontier.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// Finds the frontiers of the map and judges them: goals, filters, expected information. Keeps results between
/// decisions, so that a decision costs an update of the changed block, a wavefront, and the views near the change.
class FrontierEvaluator {
 public:
  /// Paths to goals leave `clearance_margin` [m] on either side of a robot with the outline `driven`.
  FrontierEvaluator(const FrontierParameters& parameters, const Outline& driven);
  FrontierEvaluator(const FrontierEvaluator&) = delete;
  FrontierEvaluator& operator=(const FrontierEvaluator&) = delete;

  /// Other filters and weights, from the next evaluation on; distances and clearances have to be the same.
  void setParameters(const FrontierParameters& parameters) {
    parameters_ = parameters;
    goals_.forgetFailures();
  }
  /// Takes over a map that may differ from the last one within `changed`. Returns whether any cell changed class.
  bool setMap(const OccupancyGrid& map, const CellRect& changed);
  /// Takes effect with the next map, of which all cells may differ.
  void setBounds(const ExplorationBounds& bounds) { map_.setBounds(bounds); }
  void setPlan(PlanFn plan) { plan_ = std::move(plan); }

  /// What the judgement depends on besides the map.
  struct Context {
    Vec2 robot = Vec2::Zero();  ///< in the map's frame [m]
    Vec2 start = Vec2::Zero();  ///< where the exploration began [m]
    const GoalHistory* history = nullptr;
    double least_density = 0.0;    ///< least information density of a selectable frontier; 0: any
    SharedWork* shared = nullptr;  ///< what is left to other robots; null: the robot is alone
    double speed = 1.0;            ///< mean speed on the way to a goal [m/s]
  };
  /// Finds every frontier of the map and its goal, or the reason why it has none. Paths to goals keep clear of unknown
  /// cells and leave room for a full turn: a gap whose sides have not been seen yet may prove too narrow once the robot
  /// is in it. Returns whether any frontier can be selected.
  bool evaluate(const Context& context);
  /// Judges the same frontiers again and also allows paths through gaps that the robot only just fits through.
  bool evaluateTightWays(const Context& context);
  /// The same with paths from `context.start`, if the last evaluation found no path from there to the robot and it is
  /// not the bounds that separate them.
  bool evaluateWaysFromStart(const Context& context);

  /// The selectable frontiers of the last evaluation as scored candidates.
  std::vector<GoalCandidate> candidates(const Vec2& robot);
  /// A scored candidate for the goal being driven to [m, rad], which need not belong to a frontier; nullopt if it
  /// cannot be reached.
  std::optional<GoalCandidate> candidateAt(const Pose2& goal, const Vec2& robot);

  /// Whether a blacklisted frontier can be reached without tight gaps. Frontiers behind a gap that the robot only just
  /// fits through, which the navigation failed to reach, count as unreachable.
  bool anyBlacklistedInTheOpen() const { return blacklisted_in_the_open_; }
  /// Number of reachable frontiers that the last evaluation did not judge because there were too many. [FLT-1]
  std::size_t leftOut() const { return left_out_; }
  /// Whether the map has so many frontier cells or clusters that none was judged. [FLT-1]
  bool tooMany() const { return clusters_.too_many; }
  /// Whether neither of these two limits was exceeded.
  bool allJudged() const { return left_out_ == 0 && !clusters_.too_many; }
  /// Whether the last evaluation found ground for the robot to move on.
  bool robotHasGround() const { return has_ground_; }
  /// The nearest place with a travel distance above 1.5 min_distance, from which frontiers that are too near now are
  /// not.
  std::optional<Vec2> placeToStepBackTo(const Vec2& robot) const;
  /// The space through which the last evaluation found the goals.
  const TraversableSpace& space() const { return *judged_space_; }
  /// The block of cells of `space()` that may have changed since the last call for the same space.
  CellRect takeSpaceChanges() {
    return std::exchange(judged_space_ == &space_ ? space_changes_ : tight_space_changes_, {});
  }
  /// Where to send the robot first on its way to `goal`, see limits/way_inside.h; by the last evaluation.
  Vec2 stopOnTheWay(const Vec2& robot, const Vec2& goal) const {
    return exploration::stopOnTheWay(travel_, map_, robot, goal, endOfWay(goal), lane_);
  }
  /// Computes the ways from the robot anew, through tight gaps if none leads to `place` otherwise, for `stopOnTheWay`.
  /// The judgement of the frontiers stays as it is.
  void findWays(const Vec2& robot, const Vec2& place);
  /// The end of the last evaluation's way to `place`, which may itself be too near to an obstacle; nullopt if none
  /// leads there.
  std::optional<Cell> endOfWay(const Vec2& place) const {
    return travel_.nearestReached(map_.grid(), map_.geometry().cellAt(place), parameters_.escape_radius);
  }
  /// Least unknown area that a goal has to show [m^2]; it grows with the free area of the map.
  double leastInfo() const;
  /// What a view from `goal` [m, rad] is expected to show now. [EXP-6]
  ViewGain infoAt(const Pose2& goal);
  const ObservedMap& map() const { return map_; }
  /// Travel distances from the robot, or from a fall-back's start, as of the last evaluation.
  const TravelField& travel() const { return travel_; }
  /// The cells of frontiers(), in the same order.
  const FrontierClusters& clusters() const { return clusters_; }
  const std::vector<Frontier>& frontiers() const { return frontiers_; }
  /// Whether a goal at `cell` can be reached and passes every filter. [EXP-3] [EXP-5]
  bool allowsGoal(Cell cell) const;
  /// The weights of the candidates' scores.
  const ScoreParameters& scoreWeights() const { return parameters_.score; }
  /// How the views from goals are estimated.
  const ViewParameters& view() const { return parameters_.view; }
  /// Sets Frontier::place and Frontier::cost.
  void setPlace(std::size_t frontier, int place, double cost) {
    frontiers_[frontier].place = place;
    frontiers_[frontier].cost = cost;
  }
  void reject(std::size_t frontier, Rejection reason) { frontiers_[frontier].rejection = reason; }
  /// Rejects every frontier that could be selected.
  void rejectAll(Rejection reason) {
    for (Frontier& frontier : frontiers_) {
      if (frontier.selectable()) frontier.rejection = reason;
    }
  }
  /// Fills in the cells of every frontier of the last evaluation, for display.
  void listCells();

 private:
  struct CachedView {
    std::uint64_t changes = 0;
    ViewGain gain;
  };

  void updateTightSpace();
  bool judgeAll(const TraversableSpace& space, const Vec2& from, const Context& context);
  bool judgeFromRobot(const TraversableSpace& space, const Context& context) {
    const bool any = judgeAll(space, context.robot, context);
    has_ground_ = travel_.reachedCount() > 0;
    return any;
  }
  Frontier outline(const FrontierCluster& cluster) const;
  void leaveOutAllBut(std::size_t most, const Vec2& robot);
  void judge(Frontier& frontier, const FrontierCluster& cluster, const Context& context);
  void adoptGoal(Frontier& frontier, const GoalCell& goal, const Context& context);
  Rejection judgeView(Frontier& frontier, const Context& context);
  ViewGain cachedView(Cell cell, double yaw);

  FrontierParameters parameters_;
  LaneWidth lane_;
  PlanFn plan_;
  ObservedMap map_;
  FrontierSearch search_;
  TraversableSpace space_;        ///< clear of unknown cells
  TraversableSpace tight_space_;  ///< clear of obstacles only; updated when it is needed
  CellRect tight_changes_;        ///< not yet applied to tight_space_
  const TraversableSpace* judged_space_ = &space_;
  const GoalHistory* history_ = nullptr;  ///< of the last evaluation
  CellRect space_changes_;                ///< since takeSpaceChanges()
  CellRect tight_space_changes_;          ///< the same of tight_space_
  TravelField travel_;
  FrontierClusters clusters_;
  std::vector<Frontier> frontiers_;
  std::size_t left_out_ = 0;
  bool blacklisted_in_the_open_ = false;
  bool has_ground_ = false;  ///< the robot, in the space judged last; the ways from the start say nothing of it
  std::unordered_map<std::size_t, CachedView> views_;
  FrontierGoals goals_{parameters_, map_, clusters_, travel_};
};

}  // namespace frontier_pilot::exploration
