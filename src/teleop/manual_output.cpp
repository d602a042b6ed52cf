#include "teleop/manual_output.h"

namespace frontier_pilot::teleop {

void ManualOutput::beat(const Twist2& set_point, SteadyTime now) {
  if (state_ == State::kClosed) return;
  const bool gap = last_beat_ && now - *last_beat_ > timeout_;
  last_beat_ = now;
  set_point_ = set_point.isFinite() ? set_point : Twist2{};
  asked_for_zero_ = set_point_.isZero() || (asked_for_zero_ && !gap);
  // A gap between heartbeats counts even if `update` missed it because the whole process was suspended.
  if (gap && state_ == State::kLive) state_ = State::kRearm;
}

std::optional<Twist2> ManualOutput::update(bool manual_on, SteadyTime now) {
  if (state_ == State::kClosed || !last_beat_) return std::nullopt;
  if (now - *last_beat_ > timeout_) return silence(State::kFrozen);
  if (!manual_on) return silence(State::kOff);
  if (state_ != State::kLive) state_ = asked_for_zero_ ? State::kLive : State::kRearm;
  return state_ == State::kLive ? set_point_ : Twist2{};
}

std::optional<Twist2> ManualOutput::silence(State state) {
  const bool was_silent = state_ == State::kFrozen || state_ == State::kOff || state_ == State::kWaiting;
  state_ = state;
  if (was_silent) return std::nullopt;
  asked_for_zero_ = set_point_.isZero();
  return Twist2{};
}

Twist2 ManualOutput::close() {
  state_ = State::kClosed;
  return {};
}

const char* toString(ManualOutput::State state) {
  switch (state) {
    case ManualOutput::State::kWaiting:
      return "waiting for the window";
    case ManualOutput::State::kLive:
      return "live";
    case ManualOutput::State::kRearm:
      return "waiting for a zero set-point";
    case ManualOutput::State::kFrozen:
      return "the window is frozen";
    case ManualOutput::State::kOff:
      return "manual is switched off";
    case ManualOutput::State::kClosed:
      break;
  }
  return "closed";
}

}  // namespace frontier_pilot::teleop
