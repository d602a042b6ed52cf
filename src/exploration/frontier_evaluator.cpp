#include "exploration/frontier_evaluator.h"

#include <algorithm>
#include <cmath>

#include "exploration/limits/separation.h"
#include "exploration/view_gain.h"
#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot::exploration {
namespace {

/// Clearance [m] of the paths that are tried first: with trap_margin against dead ends, and room for a full turn
/// everywhere.
double roomyClearance(const FrontierParameters& parameters, const Outline& driven) {
  return std::max(driven.halfWidth() + parameters.clearance_margin + parameters.trap_margin,
                  driven.circumscribedRadius() + parameters.clearance_margin);
}

}  // namespace

FrontierEvaluator::FrontierEvaluator(const FrontierParameters& parameters, const Outline& driven)
    : parameters_(parameters),
      lane_{driven.halfWidth() + parameters.clearance_margin, driven.halfWidth()},
      space_(roomyClearance(parameters, driven), KeepClearOf::kObstaclesAndUnknown),
      tight_space_(driven.halfWidth() + parameters.clearance_margin) {}

bool FrontierEvaluator::setMap(const OccupancyGrid& map, const CellRect& changed) {
  const bool is_new = map.geometry() != map_.geometry() || map_.empty();
  const CellRect differing = map_.update(map, changed);
  if (is_new) {
    goals_.restart();
    views_.clear();
    frontiers_.clear();
  }
  if (differing.empty() && !is_new) return false;
  search_.update(map_.grid(), differing);
  space_changes_.include(space_.update(map_.grid(), differing));
  tight_changes_.include(is_new ? map_.geometry().rect() : differing);
  return !differing.empty();
}

bool FrontierEvaluator::evaluate(const Context& context) {
  frontiers_.clear();
  if (map_.empty()) return false;
  const int max_extent = static_cast<int>(parameters_.max_cluster_extent / map_.geometry().resolution);
  clusters_ = search_.clusters(1, max_extent);
  const bool any = judgeFromRobot(space_, context);
  blacklisted_in_the_open_ = std::any_of(frontiers_.begin(), frontiers_.end(), [](const Frontier& frontier) {
    return frontier.rejection == Rejection::kBlacklisted;
  });
  return any;
}

bool FrontierEvaluator::evaluateTightWays(const Context& context) {
  updateTightSpace();
  return judgeFromRobot(tight_space_, context);
}

bool FrontierEvaluator::evaluateWaysFromStart(const Context& context) {
  const bool cut_off = robotHasGround() && !endOfWay(context.start);
  if (!cut_off || boundsSeparate(map_, context.robot, context.start)) return false;
  if (judgeAll(tight_space_, context.start, context)) return true;
  evaluateTightWays(context);
  return false;
}

void FrontierEvaluator::findWays(const Vec2& robot, const Vec2& place) {
  if (map_.empty()) return;
  const Cell from = map_.geometry().cellAt(robot);
  travel_.compute(space_, map_.grid(), from, parameters_.escape_radius);
  if (travel_.reached(map_.geometry().cellAt(place))) return;
  updateTightSpace();
  travel_.compute(tight_space_, map_.grid(), from, parameters_.escape_radius);
}

void FrontierEvaluator::updateTightSpace() {
  if (tight_changes_.empty()) return;
  tight_space_changes_.include(tight_space_.update(map_.grid(), std::exchange(tight_changes_, {})));
}

/// Returns whether any frontier can be selected.
bool FrontierEvaluator::judgeAll(const TraversableSpace& space, const Vec2& from, const Context& context) {
  judged_space_ = &space;
  history_ = context.history;
  travel_.compute(space, map_.grid(), map_.geometry().cellAt(from), parameters_.escape_radius);
  goals_.setTravel(space, map_.geometry().cellAt(from));
  frontiers_.clear();
  frontiers_.reserve(clusters_.clusters.size());
  for (const FrontierCluster& cluster : clusters_.clusters) frontiers_.push_back(outline(cluster));
  leaveOutAllBut(bounds::kMostJudgedFrontiers, context.robot);
  bool any = false;
  for (std::size_t i = 0; i < frontiers_.size(); ++i) {
    if (frontiers_[i].selectable()) judge(frontiers_[i], clusters_.clusters[i], context);
    any = any || frontiers_[i].selectable();
  }
  return any;
}

/// What is cheap to determine: where the frontier is, and whether it is worth judging.
Frontier FrontierEvaluator::outline(const FrontierCluster& cluster) const {
  const GridGeometry& geometry = map_.geometry();
  Frontier frontier;
  frontier.cell_count = cluster.cells;
  frontier.centroid = geometry.origin + geometry.resolution * (cluster.centroid + Vec2(0.5, 0.5));
  frontier.anchor = anchorOf(clusters_, cluster);
  frontier.goal = geometry.centre(frontier.anchor);
  if (cluster.component_cells < parameters_.min_frontier_cells) {
    frontier.rejection = Rejection::kTooSmall;
    return frontier;
  }
  const std::vector<Cell>& offsets = goals_.offsets();
  const int radius = offsets.empty() ? 0 : std::abs(offsets.back().x) + std::abs(offsets.back().y);
  if (!travel_.anyReached(cluster.box.grown(radius))) frontier.rejection = Rejection::kUnreachable;
  return frontier;
}

/// Keeps the `most` frontiers with the greatest size per distance from the robot, the most to see for the travel.
void FrontierEvaluator::leaveOutAllBut(std::size_t most, const Vec2& robot) {
  constexpr double kNear = 10.0;  // [m]: nearer frontiers are ranked as if they were this far away
  std::vector<std::size_t> worth_judging;
  for (std::size_t i = 0; i < frontiers_.size(); ++i) {
    if (frontiers_[i].selectable()) worth_judging.push_back(i);
  }
  left_out_ = worth_judging.size() - std::min(worth_judging.size(), most);
  if (left_out_ == 0) return;
  const auto promise = [&](std::size_t i) {
    return frontiers_[i].cell_count / std::max(kNear, (frontiers_[i].centroid - robot).norm());
  };
  std::stable_sort(worth_judging.begin(), worth_judging.end(),
                   [&](std::size_t a, std::size_t b) { return promise(a) > promise(b); });
  for (std::size_t k = most; k < worth_judging.size(); ++k) {
    frontiers_[worth_judging[k]].rejection = Rejection::kLeftOut;
  }
}

void FrontierEvaluator::judge(Frontier& frontier, const FrontierCluster& cluster, const Context& context) {
  const GoalCell goal = goals_.find(cluster, frontier.anchor);
  frontier.rejection = goal.rejection;
  if (goal.rejection == Rejection::kUnreachable) return;
  adoptGoal(frontier, goal, context);
  if (frontier.rejection == Rejection::kNone || frontier.rejection == Rejection::kTooNear) {
    const Rejection view = judgeView(frontier, context);
    if (view != Rejection::kNone) frontier.rejection = view;
  }
  if (!frontier.selectable() || context.shared == nullptr) return;
  if (context.shared->leaves(frontier.anchor, frontier.distance / context.speed, map_)) {
    frontier.rejection = Rejection::kClaimed;
  }
}

bool FrontierEvaluator::allowsGoal(Cell cell) const {
  if (!travel_.reached(cell) || goals_.judge(cell).rejection != Rejection::kNone) return false;
  return history_ == nullptr || history_->judge(map_.geometry().centre(cell)) == Rejection::kNone;
}

void FrontierEvaluator::adoptGoal(Frontier& frontier, const GoalCell& goal, const Context& context) {
  frontier.goal = map_.geometry().centre(goal.cell);
  const Vec2 towards = map_.geometry().centre(frontier.anchor) - frontier.goal;
  frontier.heading = bearing(towards.isZero() ? Vec2(frontier.goal - context.robot) : towards);
  frontier.distance = travel_.distance(goal.cell);
  frontier.obstacle_density = goal.obstacle_density;
  if (context.history == nullptr) return;
  frontier.visits = context.history->visits(frontier.goal, parameters_.visit_radius);
  const Rejection learned = context.history->judge(frontier.goal);
  if (learned != Rejection::kNone) frontier.rejection = learned;
}

Rejection FrontierEvaluator::judgeView(Frontier& frontier, const Context& context) {
  frontier.info = infoAt({frontier.goal, parameters_.view.yawTowards(frontier.heading)});
  if (frontier.info.area < leastInfo()) return Rejection::kNothingToSee;
  if (frontier.info.density < context.least_density) return Rejection::kNotRich;
  if (!plan_) return Rejection::kNone;
  const std::optional<double> planned = plan_(context.robot, frontier.goal);
  if (!planned) return Rejection::kUnreachable;
  frontier.distance = *planned;
  return frontier.distance < parameters_.min_distance ? Rejection::kTooNear : Rejection::kNone;
}

double FrontierEvaluator::leastInfo() const {
  return std::max(parameters_.min_info_area, parameters_.min_info_share * map_.freeArea());
}

ViewGain FrontierEvaluator::infoAt(const Pose2& goal) {
  if (map_.empty()) return {};
  if (parameters_.score.info_by_ray_casting) return cachedView(map_.geometry().cellAt(goal.position()), goal.yaw);
  return unknownShare(map_.grid(), goal.position(), parameters_.goal_search_radius);
}

/// A cached view is used until the area that changed within sensor_range exceeds a tenth of the area that it shows.
ViewGain FrontierEvaluator::cachedView(Cell cell, double yaw) {
  constexpr std::size_t kDirections = 120;  // yaws are rounded to so many, so that a turn by less shares the view
  constexpr std::size_t kMaxViews = 4096;
  constexpr double kTolerance = 0.1;
  if (views_.size() > kMaxViews) views_.clear();
  const Vec2 from = map_.geometry().centre(cell);
  const double cell_area = map_.geometry().resolution * map_.geometry().resolution;
  const std::uint64_t changes = map_.changesAround(from, parameters_.view.sensor_range) + 1;
  const double turn = parameters_.view.allAround() ? 0.0 : (normalizeAngle(yaw) + kPi) / (2.0 * kPi);
  const auto direction = std::min(static_cast<std::size_t>(turn * kDirections), kDirections - 1);
  CachedView& view = views_[map_.geometry().index(cell) * kDirections + direction];
  const double changed_area = static_cast<double>(changes - view.changes) * cell_area;
  const bool usable = view.changes > 0 && changed_area <= kTolerance * view.gain.area;
  if (!usable) view = {changes, viewGain(map_.grid(), {from, yaw}, parameters_.view)};
  return view.gain;
}

void FrontierEvaluator::listCells() {
  for (std::size_t i = 0; i < frontiers_.size() && i < clusters_.clusters.size(); ++i) {
    const FrontierCluster& cluster = clusters_.clusters[i];
    frontiers_[i].cells.clear();
    for (std::size_t r = cluster.first_run; r < cluster.first_run + cluster.run_count; ++r) {
      const FrontierRun& run = clusters_.runs[r];
      for (int x = run.begin; x < run.end; ++x) frontiers_[i].cells.push_back({x, run.y});
    }
  }
}

std::optional<Vec2> FrontierEvaluator::placeToStepBackTo(const Vec2& robot) const {
  if (map_.empty()) return std::nullopt;
  const Cell here = map_.geometry().cellAt(robot);
  for (const Cell offset : goals_.offsets()) {
    const Cell cell{here.x + offset.x, here.y + offset.y};
    if (travel_.reached(cell) && travel_.distance(cell) > 1.5 * parameters_.min_distance) {
      return map_.geometry().centre(cell);
    }
  }
  return std::nullopt;
}

}  // namespace frontier_pilot::exploration
