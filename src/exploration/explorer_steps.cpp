#include <algorithm>
#include <cmath>
#include <cstdio>

#include "exploration/explorer_impl.h"

namespace frontier_pilot::exploration {
namespace {

bool passed(Time since, double seconds, Time now) { return now - since >= fromSeconds(seconds); }

std::string describeGoal(const char* what, const ChosenGoal& goal) {
  char text[160];
  std::snprintf(text, sizeof text, "%s, now to (%.2f, %.2f), %.1f m away, %.2f m2 to see, ", what, goal.position.x(),
                goal.position.y(), goal.distance, goal.area);
  return text + goal.why;
}

}  // namespace

/// Runs the action of the state and, if it causes a transition, that of the new state in the same tick, and so on.
void Explorer::Impl::step(Time now) {
  constexpr int kMaxSteps = 6;
  for (int i = 0; i < kMaxSteps; ++i) {
    const std::size_t transitions = out_.transitions.size();
    switch (status_.state) {
      case ExplorerState::kIdle:
        return;
      case ExplorerState::kSelectGoal:
        selectGoal(now);
        break;
      case ExplorerState::kNavigating:
        navigate(now);
        break;
      case ExplorerState::kEvaluate:
        evaluateArrival(now);
        break;
      case ExplorerState::kDone:
        stayDone(now);
        break;
    }
    if (out_.transitions.size() == transitions) return;
  }
}

void Explorer::Impl::selectGoal(Time now) {
  // While the explorer only waits for the map to change, an unchanged map need not be judged again.
  const bool waiting = nothing_left_since_ || status_.reason == ExplorerReason::kRobotOffKnownGround;
  // One that stands aside looks again each check_period, until there is nothing that is left to others.
  const bool aside = status_.reason == ExplorerReason::kLeftToOthers && !nothing_left_since_;
  if (aside && !passed(last_decision_, parameters_.check_period, now)) return;
  const bool news = judged_changes_ != evaluator_.map().changes();
  if (nothing_left_since_ && leavesWorkToOthers()) return standAside(now);
  if (waiting && !(news && passed(last_decision_, parameters_.check_period, now))) {
    if (nothing_left_since_ && passed(*nothing_left_since_, parameters_.done_settle_time, now)) finish(now);
    return;
  }
  if (decide(ExplorerReason::kGoalSent, now)) {
    nothing_left_since_.reset();
    return;
  }
  if (!evaluator_.robotHasGround()) {
    if (status_.reason != ExplorerReason::kRobotOffKnownGround) {
      enter(ExplorerState::kSelectGoal, ExplorerReason::kRobotOffKnownGround, "", now);
    }
    nothing_left_since_.reset();
    return;
  }
  if (fallBack(FallBack::Scope::kWithoutGoal, now) != nullptr) return;
  if (leavesWorkToOthers()) return standAside(now);
  if (!nothing_left_since_) nothing_left_since_ = now;
}

void Explorer::Impl::finish(Time now) {
  nothing_left_since_.reset();
  if (inspectWhatIsLeft(now)) return;
  done_reason_ = whyNothingIsLeft();
  if (done_reason_ == ExplorerReason::kNoReachableFrontier) setWholeExplored();
  if (done_reason_ == ExplorerReason::kTooManyFrontiers) note(true, toString(*done_reason_));
  if (parameters_.return_to_start) return returnToStart(now);
  enter(ExplorerState::kDone, *done_reason_, "", now);
}

ExplorerReason Explorer::Impl::whyNothingIsLeft() const {
  if (evaluator_.tooMany() || evaluator_.leftOut() > 0) return ExplorerReason::kTooManyFrontiers;
  return evaluator_.anyBlacklistedInTheOpen() ? ExplorerReason::kAllBlacklisted : ExplorerReason::kNoReachableFrontier;
}

void Explorer::Impl::returnToStart(Time now) {
  if (!mayReturn()) return enter(ExplorerState::kDone, *done_reason_, "", now);
  evaluator_.findWays(T_map_base_->position(), start_->position());
  if (!evaluator_.map().bounds().empty() && !evaluator_.endOfWay(start_->position())) {
    note(true, "the robot does not return to the start: no way within the bounds is known");
    return enter(ExplorerState::kDone, *done_reason_, "", now);
  }
  Goal goal;
  goal.position = start_->position();
  goal.purpose = Goal::Purpose::kReturn;
  goal.yaw = start_->yaw;
  send(goal, ExplorerReason::kReturningToStart, "", now);
}

/// The time that it takes to drive to a goal at the mean speed [s]; along a straight line if the last decision found
/// no way.
double Explorer::Impl::secondsTo(const Vec2& goal) const {
  const std::optional<Cell> end = evaluator_.endOfWay(goal);
  const double way = end ? evaluator_.travel().distance(*end) : (goal - T_map_base_->position()).norm();
  return way / meanSpeed(parameters_.robot.limits);
}

void Explorer::Impl::navigate(Time now) {
  if (!goal_) return;
  if (patience_->isOver(T_map_base_->position(), parameters_.goal_timeout, now)) {
    const Goal goal = *goal_;
    cancelGoal();
    goalTimedOut(goal);
    return enter(ExplorerState::kEvaluate, ExplorerReason::kGoalTimedOut, "", now);
  }
  if (goal_->purpose != Goal::Purpose::kFrontier || !passed(last_check_, parameters_.check_period, now)) return;
  last_check_ = now;
  if (informationGone()) {
    // If the best choice is still this goal, for the little that is left, it has not been given up.
    const Goal before = *goal_;
    const bool decided = decide(ExplorerReason::kInformationGone, now);
    if (!decided || goal_->id != before.id) history_.vanished(before.position, evaluator_.map());
    if (decided) return;
    cancelGoal();
    return enter(ExplorerState::kSelectGoal, ExplorerReason::kInformationGone, "", now);
  }
  const double period = strategy_->decisionPeriods() * parameters_.decision_period;
  if (!passed(last_decision_, period, now) || decide(ExplorerReason::kBetterGoal, now)) return;
  if (countRejected(Rejection::kClaimed) > 0) {
    cancelGoal();
    standAside(now);
  }
}

/// Whether most of the area expected at the goal has been seen from a distance on the way. [EXP-6]
bool Explorer::Impl::informationGone() {
  const double left = evaluator_.infoAt(goal_->pose()).area;
  return left < evaluator_.leastInfo() || left < parameters_.vanished_share * goal_->info_area;
}

/// A reached goal that still promises more than half of the expected area after settle_time is recorded as fruitless.
void Explorer::Impl::evaluateArrival(Time now) {
  if (done_reason_) {
    arrived_.reset();
    goal_pose_.reset();
    return enter(ExplorerState::kDone, *done_reason_, "", now);
  }
  if (status_.reason == ExplorerReason::kGoalPreempted && !passed(state_since_, parameters_.yield_time, now)) return;
  if (arrived_ && arrived_->purpose == Goal::Purpose::kInspection && !hasInspected(now)) return;
  if (arrived_ && arrived_->purpose == Goal::Purpose::kFrontier) {
    const double left = evaluator_.infoAt(arrived_->pose()).area;
    const double enough = std::min(evaluator_.leastInfo(), arrived_->info_area);
    const bool promising = left >= enough && left > arrived_->info_area / 2;
    if (promising && !passed(state_since_, parameters_.settle_time, now)) return;
    if (promising) {
      history_.stayedUnknown(arrived_->position, evaluator_.map());
      strategy_->stayedUnknown();
    }
  }
  arrived_.reset();
  goal_pose_.reset();
  enter(ExplorerState::kSelectGoal, status_.reason, status_.reason_text, now);
}

void Explorer::Impl::stayDone(Time now) {
  if (ended_by_) return;  // only a start or a reset ends that
  if (!inspections_.waiting().empty()) return enter(ExplorerState::kSelectGoal, ExplorerReason::kInspecting, "", now);
  if (judged_changes_ == evaluator_.map().changes() || !passed(last_decision_, parameters_.decision_period, now))
    return;
  if (!judgeAndChoose(false, now)) {
    if (countRejected(Rejection::kClaimed) > 0) standAside(now);  // in case the others fall silent
    return;
  }
  status_.phase = ExplorerPhase::kRich;
  history_.allowRetry();
  step_backs_ = 0;
  enter(ExplorerState::kSelectGoal, ExplorerReason::kMapChanged, "", now);
}

/// Whether both are the same place, and it does not matter or hardly differs which way the robot looks there.
bool Explorer::Impl::isSame(const Goal& goal, const ChosenGoal& chosen) const {
  constexpr double kSamePlace = 0.3;  // [m]
  constexpr double kSameYaw = 0.2;    // share of the field of view
  const ViewParameters& view = evaluator_.view();
  const double turn = std::abs(angleDifference(goal.yaw, chosen.yaw));
  const bool same_yaw = view.allAround() || turn < kSameYaw * view.field_of_view;
  return same_yaw && (goal.position - chosen.position).norm() < kSamePlace;
}

/// Chooses a goal and sends it, unless it is the current one. Returns whether there is a goal now.
bool Explorer::Impl::decide(ExplorerReason reason, Time now) {
  const bool same = judged_changes_ == evaluator_.map().changes() && shared_.alone();
  if (reason == ExplorerReason::kBetterGoal && same) return true;
  const std::optional<ChosenGoal> chosen = judgeAndChoose(reason == ExplorerReason::kBetterGoal, now);
  if (!chosen) return false;
  if (inspectOnTheWay(*chosen, now)) return true;
  if (goal_ && isSame(*goal_, *chosen)) return true;
  step_backs_ = 0;
  Goal goal;
  goal.position = chosen->position;
  goal.yaw = chosen->yaw;
  goal.info_area = chosen->area;
  const std::string found_by = judged_by_ != nullptr ? std::string(", by ") + judged_by_->name : "";
  send(goal, reason, describeGoal(toString(reason), *chosen) + found_by, now);
  return true;
}

FrontierEvaluator::Context Explorer::Impl::context() {
  const bool rich = status_.phase == ExplorerPhase::kRich;
  FrontierEvaluator::Context context;
  context.robot = T_map_base_->position();
  context.start = start_->position();
  context.history = &history_;
  if (rich) context.least_density = parameters_.rich_min_density;
  if (!shared_.alone()) context.shared = &shared_;
  context.speed = meanSpeed(parameters_.robot.limits);
  return context;
}

Situation Explorer::Impl::situation(bool keep_present) {
  Situation situation;
  situation.T_map_robot = *T_map_base_;
  if (goal_) situation.current = goal_->pose();
  situation.keep_current = keep_present;
  if (!shared_.alone()) situation.shared = &shared_;
  if (parameters_.return_to_start) situation.home = start_->position();
  return situation;
}

/// Whether a frontier with an information density of at least kRichDensity can be selected or is being driven to.
bool Explorer::Impl::anyRich() {
  constexpr double kRichDensity = 0.2;  // at least a fifth of what is seen from the goal is expected to be new
  const auto rich = [](const ViewGain& info) { return info.density >= kRichDensity; };
  if (goal_ && rich(evaluator_.infoAt(goal_->pose()))) return true;
  const std::vector<Frontier>& all = evaluator_.frontiers();
  return std::any_of(all.begin(), all.end(), [&](const Frontier& f) { return f.selectable() && rich(f.info); });
}

/// With `keep_present` the goal being driven to competes too, even if it fails a filter by now: a robot that has come
/// nearer to its goal than min_distance must not turn away from it.
std::optional<ChosenGoal> Explorer::Impl::judgeAndChoose(bool keep_present, Time now) {
  history_.expire(evaluator_.map());
  judged_by_ = nullptr;
  shared_.restart();
  if (!evaluator_.evaluate(context())) judged_by_ = fallBack(FallBack::Scope::kEveryDecision, now);
  const bool selects_by_density = parameters_.rich_min_density > 0.0;  // then COVERAGE is a fall-back
  const bool judged = evaluator_.allJudged() && evaluator_.robotHasGround();
  if (!selects_by_density && judged && !anyRich()) goOnToCoverage(now);
  judged_changes_ = evaluator_.map().changes();
  last_decision_ = last_check_ = now;
  out_.frontiers_judged = true;
  std::optional<ChosenGoal> chosen = strategy_->choose(evaluator_, situation(keep_present));
  // A strategy may leave all that can be selected; another way of judging may find what it does not leave.
  if (!chosen && judged_by_ == nullptr) {
    judged_by_ = fallBack(FallBack::Scope::kEveryDecision, now);
    if (judged_by_ != nullptr) chosen = strategy_->choose(evaluator_, situation(keep_present));
  }
  chosen_ = chosen.value_or(ChosenGoal{});
  noteClaims();
  if (chosen) estimateWhole();
  return chosen;
}

}  // namespace frontier_pilot::exploration
