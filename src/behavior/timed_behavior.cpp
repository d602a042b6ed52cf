#include "frontier_pilot/behavior/timed_behavior.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "behavior/motion_profile.h"

namespace frontier_pilot::behavior {
namespace {

/// A motion must advance by this much to count as progress: [rad] or [m].
constexpr double kTurnProgress = 0.01;
constexpr double kLineProgress = 0.004;
/// A motion that ends where it begins, for all that the costmap can tell: [rad] or [m].
constexpr double kNoMotion = 1e-6;
/// A spin that stands farther past its target than this turns back [rad]. [SPN-4]
constexpr double kOvershoot = 0.05;

std::string seconds(double value) {
  std::ostringstream out;
  out << value << " s";
  return out.str();
}

}  // namespace

/// The state machine: moves or waits in every cycle, and settles once the target is reached.
class TimedBehavior::Impl {
 public:
  explicit Impl(const BehaviorParameters& parameters) : parameters_(parameters) {}

  BehaviorOutput start(const BehaviorGoal& goal, Time now);
  BehaviorOutput update(const BehaviorInputs& inputs, Time now);
  BehaviorOutput cancel(const std::string& why, Time now);
  BehaviorOutput abortByClockJump();
  void setParameters(const BehaviorParameters& parameters) { parameters_ = parameters; }

  bool active() const { return active_; }
  const BehaviorGoal& goal() const { return goal_; }

 private:
  BehaviorOutput running(const Twist2& command) const;
  BehaviorOutput end(BehaviorOutcome outcome, std::string message);
  BehaviorOutput wait();
  BehaviorOutput move(const BehaviorInputs& inputs, Time now);
  std::optional<std::string> poseProblem(const BehaviorInputs& inputs, Time now) const;
  void measure(const StampedPose2& pose, Time now);
  BehaviorOutput settle(Time now);
  BehaviorOutput turnBack(Time now);
  BehaviorOutput giveUp(BehaviorOutcome outcome, const std::string& message);
  BehaviorOutput goOn(const BehaviorInputs& inputs, double speed);
  std::string whatIsAhead(const BehaviorInputs& inputs, SweepResult seen) const;
  AxisMotion motion() const;
  MotionLimits limits() const;
  double sign() const { return motion().amount < 0.0 ? -1.0 : 1.0; }
  /// How far the target is in the direction of travel [rad] or [m].
  double remaining() const { return direction_ * (std::abs(motion().amount) - progress_); }

  BehaviorParameters parameters_;
  BehaviorGoal goal_;
  bool active_ = false;
  Time started_, last_update_;
  double elapsed_ = 0.0;
  double progress_ = 0.0;   ///< along the motion: positive towards the target
  double direction_ = 1.0;  ///< -1 while it turns back to a target that it has passed
  std::optional<StampedPose2> first_pose_, last_pose_;
  TurnCounter turned_;
  MotionEstimate estimate_;
  double least_remaining_ = 0.0;
  Time progressed_;
  std::optional<Time> settling_since_;
};

BehaviorOutput TimedBehavior::Impl::start(const BehaviorGoal& goal, Time now) {
  goal_ = goal;
  started_ = last_update_ = progressed_ = now;
  elapsed_ = progress_ = 0.0;
  direction_ = 1.0;
  least_remaining_ = std::abs(motion().amount);
  first_pose_.reset();
  last_pose_.reset();
  settling_since_.reset();
  estimate_ = {};
  if (const auto problem = problemOf(goal)) return end(BehaviorOutcome::kInvalidGoal, *problem);
  if (goal.target == 0.0) return end(BehaviorOutcome::kSucceeded, "there was nothing to do");
  active_ = true;
  return running({});
}

BehaviorOutput TimedBehavior::Impl::cancel(const std::string& why, Time now) {
  if (!active_) return {};
  elapsed_ = std::max(0.0, toSeconds(now - started_));
  return end(BehaviorOutcome::kCanceled, why);
}

BehaviorOutput TimedBehavior::Impl::abortByClockJump() {
  if (!active_) return {};
  return end(BehaviorOutcome::kPoseLost, "the clock jumped");
}

BehaviorOutput TimedBehavior::Impl::update(const BehaviorInputs& inputs, Time now) {
  if (!active_) return {};
  if (now < last_update_) return abortByClockJump();
  elapsed_ = toSeconds(now - started_);
  if (!settling_since_ && goal_.time_allowance > 0.0 && elapsed_ > goal_.time_allowance) {
    return giveUp(BehaviorOutcome::kTimeout, "not done within " + seconds(goal_.time_allowance));
  }
  if (inputs.emergency_stop) return end(BehaviorOutcome::kNoProgress, "emergency stop");
  BehaviorOutput output = goal_.kind == BehaviorKind::kWait ? wait() : move(inputs, now);
  last_update_ = now;
  return output;
}

BehaviorOutput TimedBehavior::Impl::wait() {
  progress_ = std::min(elapsed_, goal_.target);
  return elapsed_ >= goal_.target ? end(BehaviorOutcome::kSucceeded, "waited") : running({});
}

BehaviorOutput TimedBehavior::Impl::move(const BehaviorInputs& inputs, Time now) {
  if (const auto problem = poseProblem(inputs, now)) {
    // Once the target is reached, the pose no longer matters.
    if (settling_since_) return end(BehaviorOutcome::kSucceeded, "done");
    return giveUp(BehaviorOutcome::kPoseLost, *problem);
  }
  measure(*inputs.pose, now);
  if (settling_since_) return settle(now);
  const ProfileStep next = profileStep(limits(), remaining(), estimate_, 1.0 / parameters_.frequency);
  if (next.reached) {
    settling_since_ = now;
    return settle(now);
  }
  if (toSeconds(now - progressed_) > parameters_.no_progress_timeout) {
    return giveUp(BehaviorOutcome::kNoProgress, "no progress for " + seconds(parameters_.no_progress_timeout));
  }
  return goOn(inputs, next.speed);
}

std::optional<std::string> TimedBehavior::Impl::poseProblem(const BehaviorInputs& inputs, Time now) const {
  if (!inputs.pose) return "no pose";
  // A pose from the future is useless as well: the clock has jumped.
  const double age = std::abs(toSeconds(now - inputs.pose->stamp));
  if (age > parameters_.pose_timeout) return "the pose is older than " + seconds(parameters_.pose_timeout);
  if (!inputs.pose->pose.isFinite()) return "the pose is not finite";
  if (last_pose_ && isJump(last_pose_->pose, inputs.pose->pose, parameters_.jump_distance, parameters_.jump_angle)) {
    return "the pose jumped";
  }
  return std::nullopt;
}

void TimedBehavior::Impl::measure(const StampedPose2& pose, Time now) {
  const double before = progress_;
  if (!first_pose_) {
    first_pose_ = pose;
    turned_.restart(pose.pose.yaw);
  }
  const double moved = motion().axis == AxisMotion::Axis::kTurn ? turned_.add(pose.pose.yaw)
                                                                : (first_pose_->pose.inverse() * pose.pose).x;
  progress_ = sign() * moved;
  estimate_.age = std::max(0.0, toSeconds(now - pose.stamp));
  if (last_pose_ && pose.stamp > last_pose_->stamp) {
    estimate_.rate = direction_ * (progress_ - before) / toSeconds(pose.stamp - last_pose_->stamp);
  }
  last_pose_ = pose;
  const double least = motion().axis == AxisMotion::Axis::kTurn ? kTurnProgress : kLineProgress;
  if (remaining() <= least_remaining_ - least) {
    least_remaining_ = remaining();
    progressed_ = now;
  }
}

BehaviorOutput TimedBehavior::Impl::settle(Time now) {
  const bool standing = std::abs(estimate_.rate) < 0.05 * limits().min_speed && estimate_.command == 0.0;
  const bool late = toSeconds(now - *settling_since_) >= parameters_.settle_timeout;
  estimate_.command = 0.0;
  if (!standing && !late) return running({});
  const bool passed = goal_.kind == BehaviorKind::kSpin && remaining() < -kOvershoot;
  if (!passed) return end(BehaviorOutcome::kSucceeded, "done");
  return direction_ > 0.0 ? turnBack(now) : giveUp(BehaviorOutcome::kSucceeded, "it turned back too far");
}

/// A cycle that comes late, on a busy computer, lets the base turn on by its last command, past the target. It turns
/// back once.
BehaviorOutput TimedBehavior::Impl::turnBack(Time now) {
  direction_ = -1.0;
  least_remaining_ = remaining();
  progressed_ = now;
  settling_since_.reset();
  estimate_ = {};
  return running({});
}

/// Ends with `outcome`, unless the target was reached and only the way back to it has failed.
BehaviorOutput TimedBehavior::Impl::giveUp(BehaviorOutcome outcome, const std::string& message) {
  if (direction_ > 0.0) return end(outcome, message);
  return end(BehaviorOutcome::kSucceeded, "done, but past the target: " + message);
}

BehaviorOutput TimedBehavior::Impl::goOn(const BehaviorInputs& inputs, double speed) {
  AxisMotion ahead = motion();
  ahead.amount = sign() * direction_ * std::min(remaining(), speed * parameters_.simulate_ahead_time);
  if (goal_.check_collisions) {
    const SweepResult seen = inputs.look_ahead ? inputs.look_ahead(inputs.pose->pose, ahead) : SweepResult::kNoCostmap;
    if (seen != SweepResult::kClear) return giveUp(BehaviorOutcome::kCollisionAhead, whatIsAhead(inputs, seen));
  }
  estimate_.command = speed;
  const double signed_speed = sign() * direction_ * speed;
  return running(ahead.axis == AxisMotion::Axis::kTurn ? Twist2{0.0, signed_speed} : Twist2{signed_speed, 0.0});
}

/// `seen`, in words. Where something touches the footprint already, no motion of this kind can begin.
std::string TimedBehavior::Impl::whatIsAhead(const BehaviorInputs& inputs, SweepResult seen) const {
  AxisMotion none = motion();
  none.amount = sign() * direction_ * kNoMotion;  // its sign tells which half of the footprint is left behind
  const bool touches =
      seen == SweepResult::kObstacle && inputs.look_ahead(inputs.pose->pose, none) == SweepResult::kObstacle;
  if (touches) return "an obstacle touches the footprint; move away first";
  return std::string("not free ahead: ") + toString(seen);
}

AxisMotion TimedBehavior::Impl::motion() const {
  if (goal_.kind == BehaviorKind::kSpin) return {AxisMotion::Axis::kTurn, goal_.target};
  return {AxisMotion::Axis::kLine, goal_.kind == BehaviorKind::kBackUp ? -goal_.target : goal_.target};
}

MotionLimits TimedBehavior::Impl::limits() const {
  const BehaviorParameters& p = parameters_;
  const RobotLimits& robot = p.robot.limits;
  const bool spin = goal_.kind == BehaviorKind::kSpin;
  const double wanted = goal_.speed > 0.0 ? goal_.speed : p.default_linear_vel;
  const double fastest = spin ? std::min(p.max_rotational_vel, robot.max_angular) : std::min(wanted, robot.max_linear);
  const double slowest = std::min(spin ? p.min_rotational_vel : p.min_linear_vel, fastest);
  return {spin ? robot.max_angular_acc : std::min(p.linear_acc_lim, robot.max_linear_acc), slowest, fastest};
}

BehaviorOutput TimedBehavior::Impl::running(const Twist2& command) const {
  BehaviorOutput output;
  output.outcome = BehaviorOutcome::kRunning;
  output.command = command;
  output.progress = goal_.kind == BehaviorKind::kSpin ? sign() * progress_ : progress_;
  output.elapsed = elapsed_;
  return output;
}

BehaviorOutput TimedBehavior::Impl::end(BehaviorOutcome outcome, std::string message) {
  active_ = false;
  BehaviorOutput output = running({});
  output.outcome = outcome;
  output.message = std::move(message);
  return output;
}

TimedBehavior::TimedBehavior(const BehaviorParameters& parameters) : impl_(std::make_unique<Impl>(parameters)) {}
TimedBehavior::~TimedBehavior() = default;
TimedBehavior::TimedBehavior(TimedBehavior&&) noexcept = default;
TimedBehavior& TimedBehavior::operator=(TimedBehavior&&) noexcept = default;

BehaviorOutput TimedBehavior::start(const BehaviorGoal& goal, Time now) { return impl_->start(goal, now); }
BehaviorOutput TimedBehavior::update(const BehaviorInputs& inputs, Time now) { return impl_->update(inputs, now); }
BehaviorOutput TimedBehavior::cancel(const std::string& why, Time now) { return impl_->cancel(why, now); }
BehaviorOutput TimedBehavior::abortByClockJump() { return impl_->abortByClockJump(); }
void TimedBehavior::setParameters(const BehaviorParameters& parameters) { impl_->setParameters(parameters); }
bool TimedBehavior::active() const { return impl_->active(); }
const BehaviorGoal& TimedBehavior::goal() const { return impl_->goal(); }

void BehaviorParameters::check(Problems& problems) const {
  if (min_rotational_vel > max_rotational_vel) {
    problems.emplace_back("min_rotational_vel: must not exceed max_rotational_vel");
  }
}

}  // namespace frontier_pilot::behavior
