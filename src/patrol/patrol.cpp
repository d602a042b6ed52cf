#include "frontier_pilot/patrol/patrol.h"

#include <cmath>
#include <sstream>

#include "patrol/step_driver.h"

namespace frontier_pilot::patrol {
namespace {

/// A step must advance by this much to count as progress: [m] or [rad].
constexpr double kProgress = 0.01;
/// A robot slower than this counts as standing: [m/s], [rad/s].
constexpr Twist2 kStandstill{0.004, 0.01};

bool stands(const Twist2& twist) {
  return std::abs(twist.linear) <= kStandstill.linear && std::abs(twist.angular) <= kStandstill.angular;
}

std::string seconds(double value) {
  std::ostringstream out;
  out << value << " s";
  return out.str();
}

}  // namespace

const char* toString(PatrolOutcome outcome) {
  constexpr const char* kNames[] = {"idle",         "running",        "completed",       "canceled",
                                    "invalid goal", "no odometry",    "bad odometry",    "odometry jumped",
                                    "blocked",      "emergency stop", "the clock jumped"};
  return kNames[static_cast<int>(outcome)];
}

Patrol::Patrol(const PatrolParameters& parameters)
    : parameters_(parameters), driver_(std::make_unique<StepDriver>(withinLimits(parameters))) {}
Patrol::~Patrol() = default;

PatrolOutput Patrol::start(const PatrolOrder& goal, Time now) {
  if (const auto problem = problemOf(goal, parameters_)) return end(PatrolOutcome::kInvalidGoal, *problem);
  active_ = true;
  goal_ = goal;
  steps_ = planPatrol(goal);
  step_ = 0;
  leg_ = 0;
  phase_ = Phase::kWaiting;
  last_sample_.reset();
  held_since_.reset();
  started_ = last_update_ = progressed_ = now;
  return running({});
}

PatrolOutput Patrol::cancel() {
  if (!active_) return {};
  return end(PatrolOutcome::kCanceled, "patrol canceled");
}

PatrolOutput Patrol::abortByClockJump() {
  if (!active_) return {};
  return end(PatrolOutcome::kClockJump, "aborted: the clock jumped");
}

PatrolOutput Patrol::update(const PatrolInputs& inputs, Time now) {
  if (!active_) return {};
  if (now < last_update_) return abortByClockJump();
  if (const auto broken = fault(inputs, now)) return end(broken->outcome, broken->text);
  PatrolOutput output = running({});
  if (inputs.odometry) {
    if (phase_ == Phase::kMoving) driver_->observe(*inputs.odometry);
    if (const auto stuck = blocked(inputs, now)) return end(stuck->outcome, stuck->text);
    output = advance(*inputs.odometry, inputs.wheels_held_by.has_value(), now);
    last_sample_ = inputs.odometry;
  }
  last_update_ = now;
  return output;
}

std::optional<Patrol::Fault> Patrol::fault(const PatrolInputs& inputs, Time now) const {
  if (inputs.emergency_stop) return Fault{PatrolOutcome::kEmergencyStop, "aborted: emergency stop"};
  if (inputs.odometry_problem) {
    return Fault{PatrolOutcome::kBadOdometry, "aborted: bad odometry: " + *inputs.odometry_problem};
  }
  const Time heard = inputs.odometry ? inputs.odometry->stamp : started_;
  if (toSeconds(now - heard) > parameters_.odometry_timeout) {
    return Fault{PatrolOutcome::kNoOdometry, "aborted: no odometry for " + seconds(parameters_.odometry_timeout)};
  }
  if (inputs.odometry && last_sample_ &&
      isJump(last_sample_->T_odom_base, inputs.odometry->T_odom_base, parameters_.jump_distance,
             parameters_.jump_angle)) {
    return Fault{PatrolOutcome::kOdometryJump, "aborted: odometry jumped"};
  }
  return std::nullopt;
}

std::optional<Patrol::Fault> Patrol::blocked(const PatrolInputs& inputs, Time now) {
  if (!inputs.wheels_held_by) held_since_.reset();
  if (inputs.wheels_held_by && !held_since_) held_since_ = now;
  if (phase_ == Phase::kMoving && driver_->progress() >= best_progress_ + kProgress) {
    best_progress_ = driver_->progress();
    progressed_ = now;
  }
  const Duration limit = fromSeconds(parameters_.blocked_timeout);
  const std::string text = "aborted: blocked for " + seconds(parameters_.blocked_timeout) + ": ";
  if (held_since_ && now - *held_since_ >= limit) {
    return Fault{PatrolOutcome::kBlocked, text + *inputs.wheels_held_by + " holds the wheels"};
  }
  if (now - progressed_ >= limit) return Fault{PatrolOutcome::kBlocked, text + "no progress"};
  return std::nullopt;
}

PatrolOutput Patrol::advance(const MotionSample& sample, bool held, Time now) {
  switch (phase_) {
    case Phase::kWaiting:
      T_odom_plan_ = sample.T_odom_base;
      return beginStep(sample, now);
    case Phase::kSettling:
      return settle(sample, now);
    case Phase::kMoving:
      break;
  }
  return drive(sample, held, now);
}

PatrolOutput Patrol::settle(const MotionSample& sample, Time now) {
  const double waited = toSeconds(now - settling_since_);
  // Odometry from before the zero command does not tell whether the robot has stopped.
  const bool rests = sample.stamp > settling_since_ && stands(sample.twist);
  if (!rests && waited < parameters_.settle_timeout) return running({});
  if (step_ == steps_.size()) return end(PatrolOutcome::kCompleted, completeText());
  return beginStep(sample, now);
}

PatrolOutput Patrol::beginStep(const MotionSample& sample, Time now) {
  driver_->begin(steps_[step_], T_odom_plan_, sample);
  phase_ = Phase::kMoving;
  best_progress_ = driver_->progress();
  progressed_ = now;
  return drive(sample, false, now);
}

PatrolOutput Patrol::drive(const MotionSample& sample, bool held, Time now) {
  if (driver_->reached()) {
    phase_ = Phase::kSettling;
    settling_since_ = now;
    ++step_;
    return running({});
  }
  if (held) driver_->rest();
  PatrolOutput output = running(driver_->command(toSeconds(now - last_update_), toSeconds(now - sample.stamp)));
  const bool arc = driver_->step().kind == PatrolStep::Kind::kArc;
  const int lap = arc ? static_cast<int>(std::max(0.0, driver_->progress()) / (2.0 * kPi)) : 0;
  const int leg = driver_->step().leg + lap;
  if (driver_->step().leg > 0 && leg > leg_) {
    leg_ = leg;
    output.started_leg = leg;
  }
  return output;
}

PatrolOutput Patrol::running(const Twist2& command) const {
  PatrolOutput output;
  output.outcome = PatrolOutcome::kRunning;
  output.command = command;
  return output;
}

PatrolOutput Patrol::end(PatrolOutcome outcome, std::string text) {
  active_ = false;
  PatrolOutput output;
  output.outcome = outcome;
  output.command = Twist2();
  output.text = std::move(text);
  return output;
}

std::string Patrol::completeText() const {
  return std::string(toString(static_cast<PatrolShape>(static_cast<int>(goal_.mode)))) + " patrol complete!!";
}

}  // namespace frontier_pilot::patrol
