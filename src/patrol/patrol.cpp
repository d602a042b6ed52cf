#include "frontier_pilot/patrol/patrol.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <utility>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "patrol/plan.h"
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
  constexpr const char* kNames[] = {"idle",         "running",        "completed",        "canceled",
                                    "invalid goal", "no odometry",    "bad odometry",     "odometry jumped",
                                    "blocked",      "emergency stop", "the clock jumped", "obstacle ahead"};
  return kNames[static_cast<int>(outcome)];
}

/// The state machine: waits for odometry, then moves and settles, step by step.
class Patrol::Impl {
 public:
  explicit Impl(const PatrolParameters& parameters) : parameters_(parameters), driver_(withinLimits(parameters)) {}

  PatrolOutput start(const PatrolOrder& goal, Time now);
  PatrolOutput update(const PatrolInputs& inputs, Time now);
  PatrolOutput cancel();
  PatrolOutput abortByClockJump();
  void setParameters(const PatrolParameters& parameters);
  bool active() const { return active_; }

 private:
  enum class Phase { kWaiting, kMoving, kSettling };
  struct Fault {
    PatrolOutcome outcome;
    std::string text;
  };

  PatrolOutput end(PatrolOutcome outcome, std::string text);
  std::optional<Fault> fault(const PatrolInputs& inputs, Time now) const;
  std::optional<Fault> blocked(const PatrolInputs& inputs, Time now);
  PatrolOutput advance(const PatrolInputs& inputs, Time now);
  PatrolOutput settle(const PatrolInputs& inputs, Time now);
  PatrolOutput beginStep(const PatrolInputs& inputs, Time now);
  PatrolOutput drive(const PatrolInputs& inputs, Time now);
  PatrolOutput standBefore(const std::string& obstacle, Time now);
  PatrolOutput running(const Twist2& command) const;
  std::string completeText() const;

  PatrolParameters parameters_;
  StepDriver driver_;
  bool active_ = false;
  PatrolOrder goal_;
  std::vector<PatrolStep> steps_;
  std::size_t step_ = 0;  ///< index of the current step; of the next one while waiting or settling
  Phase phase_ = Phase::kWaiting;
  int leg_ = 0;
  Pose2 T_odom_plan_;
  std::optional<MotionSample> last_sample_;
  Time started_, last_update_, settling_since_;
  std::optional<Time> held_since_, obstructed_since_;
  Time progressed_;  ///< when the step last made progress; moved on by the time before obstacles since then
  double best_progress_ = 0.0;
};

PatrolOutput Patrol::Impl::start(const PatrolOrder& goal, Time now) {
  if (const auto problem = problemOf(goal, parameters_)) return end(PatrolOutcome::kInvalidGoal, *problem);
  active_ = true;
  goal_ = goal;
  steps_ = planPatrol(goal);
  step_ = 0;
  leg_ = 0;
  phase_ = Phase::kWaiting;
  last_sample_.reset();
  held_since_.reset();
  obstructed_since_.reset();
  started_ = last_update_ = progressed_ = now;
  return running({});
}

void Patrol::Impl::setParameters(const PatrolParameters& parameters) {
  parameters_ = parameters;
  driver_.setParameters(withinLimits(parameters));
}

PatrolOutput Patrol::Impl::cancel() {
  if (!active_) return {};
  return end(PatrolOutcome::kCanceled, "patrol canceled");
}

PatrolOutput Patrol::Impl::abortByClockJump() {
  if (!active_) return {};
  return end(PatrolOutcome::kClockJump, "aborted: the clock jumped");
}

PatrolOutput Patrol::Impl::update(const PatrolInputs& inputs, Time now) {
  if (!active_) return {};
  if (now < last_update_) return abortByClockJump();
  if (const auto broken = fault(inputs, now)) return end(broken->outcome, broken->text);
  PatrolOutput output = running({});
  if (inputs.odometry) {
    if (phase_ == Phase::kMoving) driver_.observe(*inputs.odometry);
    if (const auto stuck = blocked(inputs, now)) return end(stuck->outcome, stuck->text);
    output = advance(inputs, now);
    last_sample_ = inputs.odometry;
  }
  last_update_ = now;
  return output;
}

std::optional<Patrol::Impl::Fault> Patrol::Impl::fault(const PatrolInputs& inputs, Time now) const {
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

std::optional<Patrol::Impl::Fault> Patrol::Impl::blocked(const PatrolInputs& inputs, Time now) {
  if (!inputs.wheels_held_by) held_since_.reset();
  if (inputs.wheels_held_by && !held_since_) held_since_ = now;
  if (phase_ == Phase::kMoving && driver_.progress() >= best_progress_ + kProgress) {
    best_progress_ = driver_.progress();
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

PatrolOutput Patrol::Impl::advance(const PatrolInputs& inputs, Time now) {
  switch (phase_) {
    case Phase::kWaiting:
      if (inputs.is_connecting) {
        progressed_ = now;
        return running({});
      }
      T_odom_plan_ = inputs.odometry->T_odom_base;
      return beginStep(inputs, now);
    case Phase::kSettling:
      return settle(inputs, now);
    case Phase::kMoving:
      break;
  }
  return drive(inputs, now);
}

PatrolOutput Patrol::Impl::settle(const PatrolInputs& inputs, Time now) {
  const MotionSample& sample = *inputs.odometry;
  const double waited = toSeconds(now - settling_since_);
  // Odometry from before the zero command does not tell whether the robot has stopped.
  const bool rests = sample.stamp > settling_since_ && stands(sample.twist);
  if (!rests && waited < parameters_.settle_timeout) return running({});
  if (step_ == steps_.size()) return end(PatrolOutcome::kCompleted, completeText());
  return beginStep(inputs, now);
}

PatrolOutput Patrol::Impl::beginStep(const PatrolInputs& inputs, Time now) {
  driver_.begin(steps_[step_], T_odom_plan_, *inputs.odometry);
  phase_ = Phase::kMoving;
  best_progress_ = driver_.progress();
  progressed_ = now;
  return drive(inputs, now);
}

PatrolOutput Patrol::Impl::drive(const PatrolInputs& inputs, Time now) {
  const MotionSample& sample = *inputs.odometry;
  if (driver_.reached()) {
    phase_ = Phase::kSettling;
    settling_since_ = now;
    ++step_;
    return running({});
  }
  if (inputs.wheels_held_by) driver_.rest();
  const Twist2 command = driver_.command(toSeconds(now - last_update_), toSeconds(now - sample.stamp));
  // While another source drives, the robot goes where that one looks.
  if (inputs.way_ahead && !inputs.wheels_held_by) {
    const auto in_the_way =
        inputs.way_ahead(sample.T_odom_base, driver_.ahead(command, parameters_.simulate_ahead_time));
    if (in_the_way) return standBefore(*in_the_way, now);
  }
  obstructed_since_.reset();
  PatrolOutput output = running(command);
  const bool arc = driver_.step().kind == PatrolStep::Kind::kArc;
  const int lap = arc ? static_cast<int>(std::max(0.0, driver_.progress()) / (2.0 * kPi)) : 0;
  const int leg = driver_.step().leg + lap;
  if (driver_.step().leg > 0 && leg > leg_) {
    leg_ = leg;
    output.started_leg = leg;
  }
  return output;
}

/// Stands still, and gives up when what is in the way stays there. This time does not count as one without progress.
PatrolOutput Patrol::Impl::standBefore(const std::string& obstacle, Time now) {
  if (!obstructed_since_) obstructed_since_ = now;
  progressed_ = std::min(now, progressed_ + (now - last_update_));
  if (toSeconds(now - *obstructed_since_) >= parameters_.obstacle_timeout)
    return end(PatrolOutcome::kObstacleAhead, "aborted: " + obstacle);
  driver_.rest();
  return running({});
}

PatrolOutput Patrol::Impl::running(const Twist2& command) const {
  PatrolOutput output;
  output.outcome = PatrolOutcome::kRunning;
  output.command = command;
  return output;
}

PatrolOutput Patrol::Impl::end(PatrolOutcome outcome, std::string text) {
  active_ = false;
  PatrolOutput output;
  output.outcome = outcome;
  output.command = Twist2();
  output.text = std::move(text);
  return output;
}

std::string Patrol::Impl::completeText() const {
  return std::string(toString(static_cast<PatrolShape>(static_cast<int>(goal_.mode)))) + " patrol complete!!";
}

Patrol::Patrol(const PatrolParameters& parameters) : impl_(std::make_unique<Impl>(parameters)) {}
Patrol::~Patrol() = default;

PatrolOutput Patrol::start(const PatrolOrder& goal, Time now) { return impl_->start(goal, now); }
PatrolOutput Patrol::update(const PatrolInputs& inputs, Time now) { return impl_->update(inputs, now); }
PatrolOutput Patrol::cancel() { return impl_->cancel(); }
PatrolOutput Patrol::abortByClockJump() { return impl_->abortByClockJump(); }
void Patrol::setParameters(const PatrolParameters& parameters) { impl_->setParameters(parameters); }
bool Patrol::active() const { return impl_->active(); }

}  // namespace frontier_pilot::patrol
