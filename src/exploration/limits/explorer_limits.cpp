#include <utility>

#include "exploration/explorer_impl.h"
#include "exploration/limits/separation.h"

namespace frontier_pilot::exploration {

void Explorer::Impl::setBounds(const ExplorationBounds& bounds, const OccupancyGrid& map) {
  evaluator_.setBounds(bounds);
  bounds_changed_ = true;
  status_.whole.reset();  // it was the whole of what the old bounds enclose
  if (!map.empty()) setMap(map, map.geometry().rect());
}

/// Counts what has passed since the last tick, if the robot was exploring then. [EXP-10]
void Explorer::Impl::countExploring(double driven, Time now) {
  const bool explores = status_.state != ExplorerState::kIdle && status_.state != ExplorerState::kDone && !unable_at_;
  if (explores && last_update_) rules_.count(sinceLastTick(now), driven);
}

StoppingRules::State Explorer::Impl::rulesState() const {
  const bool estimated = status_.whole && status_.whole->isEstimated();
  return {evaluator_.map().freeArea(), status_.shareExplored(), estimated, battery_};
}

/// Lets an exploration go on that a stopping rule has ended; nothing if none has.
void Explorer::Impl::startAgain(Time now) {
  if (!ended_by_) return;
  ended_by_.reset();
  endReturn();
  rules_.startOver(rulesState());
  cancelGoal();
  if (status_.state != ExplorerState::kIdle) enter(ExplorerState::kSelectGoal, ExplorerReason::kStartedAgain, "", now);
}

/// Whether the explorer has to leave the robot to another client of the navigation, until that goal has ended: no goal
/// is sent meanwhile, because it would replace the other one. [EXP-11]
bool Explorer::Impl::yield(const ExplorerInputs& inputs, Time now) {
  if (!inputs.others_goal) return false;
  if (status_.state == ExplorerState::kDone) return true;
  cancelGoal();
  nothing_left_since_.reset();
  if (status_.reason != ExplorerReason::kOthersGoal) {
    enter(ExplorerState::kIdle, ExplorerReason::kOthersGoal, "", now);
  }
  return true;
}

/// Whether the state's action may be taken: the robot is within the bounds, or drives to a goal that is, and no
/// stopping rule has ended the exploration. A rule that has ended it counts as met until it is started again, although
/// a charge may recover; one that is met after nothing was left to explore does not change why it ended. [EXP-10]
bool Explorer::Impl::withinLimits(Time now) {
  if (std::exchange(bounds_changed_, false) && goal_) {
    cancelGoal();
    enter(ExplorerState::kSelectGoal, ExplorerReason::kBoundsChanged, "", now);
  }
  if (status_.state == ExplorerState::kDone) return !ended_by_;
  const bool returning = (goal_ && goal_->purpose == Goal::Purpose::kReturn) ||
                         (status_.state == ExplorerState::kEvaluate && done_reason_);
  if (!ended_by_ && !done_reason_) ended_by_ = rules_.met(rulesState());
  if (ended_by_ && !returning) endByRule(now);
  return status_.state != ExplorerState::kDone && keepWithinBounds(now);
}

/// A robot that stands outside, or gets there on its way, is not driven back: only a person can tell whether the bounds
/// or the place are wrong.
bool Explorer::Impl::keepWithinBounds(Time now) {
  if (status_.state != ExplorerState::kSelectGoal && status_.state != ExplorerState::kNavigating) return true;
  if (evaluator_.map().bounds().contain(T_map_base_->position())) return true;
  cancelGoal();
  nothing_left_since_.reset();
  if (status_.reason != ExplorerReason::kRobotOutOfBounds) {
    enter(ExplorerState::kSelectGoal, ExplorerReason::kRobotOutOfBounds, "", now);
    note(true, toString(ExplorerReason::kRobotOutOfBounds));
  }
  return false;
}

void Explorer::Impl::endByRule(Time now) {
  cancelGoal();
  nothing_left_since_.reset();
  done_reason_ = ended_by_;
  if (parameters_.return_to_start) return returnToStart(now);
  enter(ExplorerState::kDone, *ended_by_, "", now);
}

/// Whether the way to the start begins and ends within the bounds and does not have to lead out of them.
bool Explorer::Impl::mayReturn() const {
  const ObservedMap& map = evaluator_.map();
  const Vec2 here = T_map_base_->position(), start = start_->position();
  return map.bounds().contain(here) && map.bounds().contain(start) && !boundsSeparate(map, here, start);
}

}  // namespace frontier_pilot::exploration
