#include "frontier_pilot/exploration/explorer.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "exploration/explorer_impl.h"

namespace frontier_pilot::exploration {
namespace {

/// No view shows more than the scanner measures.
ExplorerParameters withScannersView(ExplorerParameters parameters) {
  ViewParameters& view = parameters.frontier.view;
  const ScannerModel& scanner = parameters.robot.scanner;
  view.sensor_range = std::min(view.sensor_range, scanner.range_max);
  view.field_of_view = scanner.field_of_view;
  view.direction = normalizeAngle(scanner.yaw + scanner.angle_min + 0.5 * scanner.field_of_view);
  return parameters;
}

}  // namespace

Explorer::Explorer(const ExplorerParameters& parameters) : impl_(std::make_unique<Impl>(parameters)) {}
Explorer::~Explorer() = default;
Explorer::Explorer(Explorer&&) noexcept = default;
Explorer& Explorer::operator=(Explorer&&) noexcept = default;

void Explorer::setMap(const OccupancyGrid& map, const CellRect& changed) { impl_->setMap(map, changed); }
void Explorer::setBounds(const ExplorationBounds& bounds, const OccupancyGrid& map) { impl_->setBounds(bounds, map); }
const ExplorationBounds& Explorer::bounds() const { return impl_->evaluator().map().bounds(); }
void Explorer::setReturnToStart(bool on) { impl_->setReturnToStart(on); }
bool Explorer::returnsToStart() const { return impl_->returnsToStart(); }
const std::optional<Pose2>& Explorer::start() const { return impl_->start(); }
void Explorer::setStart(const Pose2& T_map_start) { impl_->setStart(T_map_start); }
std::optional<ExplorerReason> Explorer::endedBy() const { return impl_->endedBy(); }
void Explorer::setParameters(const ExplorerParameters& parameters) { impl_->setParameters(parameters); }
void Explorer::setPlan(PlanFn plan) { impl_->evaluator().setPlan(std::move(plan)); }
std::string Explorer::inspect(const Pose2& pose) { return impl_->inspect(pose); }
void Explorer::clearInspections() { impl_->clearInspections(); }
void Explorer::leaveMap() { impl_->leaveMap(); }
std::vector<Pose2> Explorer::inspections() const { return impl_->inspections(); }
ExplorerOutput Explorer::update(const ExplorerInputs& inputs, Time now) { return impl_->update(inputs, now); }
const std::vector<Frontier>& Explorer::frontiers() const { return impl_->evaluator().frontiers(); }
const std::vector<Frontier>& Explorer::frontiersWithCells() {
  impl_->evaluator().listCells();
  return frontiers();
}
const GridGeometry& Explorer::geometry() const { return impl_->evaluator().map().geometry(); }
const std::vector<BlacklistedPlace>& Explorer::blacklist() const { return impl_->history().blacklist(); }
const std::vector<Vec2>& Explorer::tour() const { return impl_->tour(); }
std::vector<Claim> Explorer::claims() const { return impl_->claims(); }
std::string Explorer::explain() const { return impl_->explain(); }
const std::optional<Pose2>& Explorer::goal() const { return impl_->goal(); }

Explorer::Impl::Impl(const ExplorerParameters& parameters)
    : parameters_(withScannersView(parameters)),
      evaluator_(parameters_.frontier, parameters_.robot.drivenOutline()),
      history_(parameters_.blacklist, parameters_.max_goal_retries),
      strategy_(makeStrategy(parameters_)),
      rules_(parameters_.until) {
  evaluator_.setBounds(parameters_.bounds.polygons());
}

void Explorer::Impl::setParameters(const ExplorerParameters& parameters) {
  parameters_.goal_timeout = parameters.goal_timeout;
  parameters_.frontier = withScannersView(parameters).frontier;
  evaluator_.setParameters(parameters_.frontier);
  constexpr std::uint64_t kNever = std::numeric_limits<std::uint64_t>::max();
  if (status_.state != ExplorerState::kDone) judged_changes_ = kNever;  // the same map is to be judged again
}

void Explorer::Impl::setMap(const OccupancyGrid& map, const CellRect& changed) {
  const std::uint32_t restarts = evaluator_.map().restarts();
  evaluator_.setMap(map, changed);
  if (evaluator_.map().restarts() != restarts) history_.rebase(evaluator_.map());
}

ExplorerOutput Explorer::Impl::update(const ExplorerInputs& inputs, Time now) {
  out_ = {};
  heedClock(now);
  const double before = status_.distance_travelled;
  trackMotion(inputs, now);
  battery_ = inputs.battery;
  countExploring(status_.distance_travelled - before, now);
  if (!shared_.alone() || !inputs.others.empty()) shared_.setOthers(inputs.others);
  if (inputs.reset) reset(now);
  if (inputs.start) startAgain(now);
  obeyReplacedMap(now);
  if (ready(inputs, now) && !waitsForNavigation(now)) {
    if (!start_) start_ = T_map_base_;
    if (status_.state == ExplorerState::kIdle) {
      enter(ExplorerState::kSelectGoal, ExplorerReason::kInputsComplete, "", now);
    }
    for (const GoalEvent& event : inputs.goal_events) handleEvent(event, now);
    obeyClearedInspections(now);
    if (status_.state != ExplorerState::kIdle && withinLimits(now)) step(now);
  }
  countFrontiers();
  last_update_ = now;
  out_.status = status_;
  return std::move(out_);
}

void Explorer::Impl::reset(Time now) {
  history_.reset();
  strategy_->reset();
  rules_.startOver(rulesState());  // with the share that may have ended the exploration
  status_.whole.reset();
  ended_by_.reset();
  step_backs_ = 0;
  nothing_left_since_.reset();
  endReturn();
  status_.phase = ExplorerPhase::kRich;
  cancelGoal();
  const bool idle = status_.state == ExplorerState::kIdle;
  enter(idle ? ExplorerState::kIdle : ExplorerState::kSelectGoal, ExplorerReason::kReset, "", now);
}

void Explorer::Impl::handleEvent(const GoalEvent& event, Time now) {
  if (!goal_ || goal_->id != event.goal_id) return;  // the event belongs to a goal that has been replaced
  const Goal goal = *goal_;
  goal_.reset();
  if (event.kind == GoalEvent::Kind::kReached) unable_at_.reset();
  if (event.kind == GoalEvent::Kind::kReached && goal.on_the_way) return stopReached(goal, now);
  switch (event.kind) {
    case GoalEvent::Kind::kReached:
      ++status_.goals_reached;
      arrived_ = goal;
      if (goal.purpose == Goal::Purpose::kInspection) {
        return enter(ExplorerState::kEvaluate, ExplorerReason::kInspecting, "", now);
      }
      history_.reached(goal.position);
      return enter(ExplorerState::kEvaluate, ExplorerReason::kGoalReached, "", now);
    case GoalEvent::Kind::kPreempted:
      return enter(ExplorerState::kEvaluate, ExplorerReason::kGoalPreempted, event.text, now);
    case GoalEvent::Kind::kUnable:
      if (!givesUpReturn(goal, now)) return standUntilItCanDrive(event.text, now);
      [[fallthrough]];
    case GoalEvent::Kind::kAborted:
    case GoalEvent::Kind::kRejected:
      goalFailed(goal, event.text);
      return enter(ExplorerState::kEvaluate, ExplorerReason::kGoalFailed, event.text, now);
  }
}

/// A navigation with a large tolerance may call a stop reached where the robot stands. The same stop would be sent for
/// ever, so that the goal behind it counts as failed.
void Explorer::Impl::stopReached(const Goal& goal, Time now) {
  constexpr double kLeast = 0.1;  // [m]: what a robot has to move for a stop on the way
  if ((T_map_base_->position() - goal.sent_from).norm() >= kLeast) {
    if (goal.purpose == Goal::Purpose::kReturn) return returnToStart(now);
    return enter(ExplorerState::kSelectGoal, ExplorerReason::kGoalReached, "reached a stop on the way", now);
  }
  const std::string what = "the navigation calls a stop on the way reached without driving there";
  goalFailed(goal, what);
  enter(ExplorerState::kEvaluate, ExplorerReason::kGoalFailed, what, now);
}

/// Only the goals of frontiers are blacklisted.
void Explorer::Impl::goalFailed(const Goal& goal, const std::string& what) {
  ++status_.goals_failed;
  if (goal.purpose == Goal::Purpose::kInspection) inspectionFailed(goal, what);
  if (goal.purpose != Goal::Purpose::kFrontier) return;
  if (history_.failed(goal.position, what, evaluator_.map())) note(true, "goal blacklisted: " + what);
}

void Explorer::Impl::goalTimedOut(const Goal& goal) {
  ++status_.goals_failed;
  if (goal.purpose == Goal::Purpose::kInspection) inspectionFailed(goal, "timed out");
  if (goal.purpose != Goal::Purpose::kFrontier) return;
  history_.timedOut(goal.position, evaluator_.map());
  note(true, "goal blacklisted: timed out");
}

void Explorer::Impl::cancelGoal() {
  if (goal_) {
    out_.command = {GoalCommand::Kind::kCancel, goal_->id, {}};
  } else if (out_.command.kind == GoalCommand::Kind::kSend) {
    out_.command = {};
  }
  goal_.reset();
  arrived_.reset();
  goal_pose_.reset();
}

void Explorer::Impl::send(Goal goal, ExplorerReason reason, const std::string& text, Time now) {
  goal.id = next_goal_id_++;
  goal.sent_from = T_map_base_->position();
  const Vec2 stop = evaluator_.stopOnTheWay(T_map_base_->position(), goal.position);
  goal.on_the_way = stop != goal.position;
  if (goal.purpose != Goal::Purpose::kReturn) endReturn();
  goal_ = goal;
  patience_.emplace(goal.sent_from, secondsTo(stop), meanSpeed(parameters_.robot.limits), now);
  goal_pose_ = Pose2(stop, goal.on_the_way ? bearing(goal.position - stop) : goal.yaw);
  out_.command = {GoalCommand::Kind::kSend, goal.id, *goal_pose_};
  ++status_.goals_sent;
  enter(ExplorerState::kNavigating, reason, text, now);
}

void Explorer::Impl::enter(ExplorerState state, ExplorerReason reason, const std::string& text, Time now) {
  if (state != status_.state) state_since_ = now;
  if (state == ExplorerState::kSelectGoal) was_running_ = true;
  if (state == ExplorerState::kDone) endReturn();
  status_.state = state;
  status_.reason = reason;
  status_.reason_text = text.empty() ? toString(reason) : text;
  countFrontiers();
  out_.transitions.push_back(status_);
}

}  // namespace frontier_pilot::exploration
