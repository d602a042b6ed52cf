#include "frontier_pilot/avoid/avoider.h"

#include <stdexcept>

namespace frontier_pilot::avoid {
namespace {

/// Ticks may come slightly early or late; without this slack an early one would prolong a phase by a whole tick.
constexpr Duration kTickSlack = std::chrono::milliseconds(10);

const AvoiderParameters& checked(const AvoiderParameters& parameters) {
  Problems problems;
  parameters.check(problems);
  if (!problems.empty()) throw std::invalid_argument("avoider: " + problems.front());
  return parameters;
}

}  // namespace

const char* toString(AvoiderState state) {
  constexpr const char* kNames[] = {"idle", "waiting", "clear", "reverse", "rotate", "fault", "stuck"};
  return kNames[static_cast<int>(state)];
}

Avoider::Avoider(const AvoiderParameters& parameters)
    : parameters_(checked(parameters)), distances_(parameters), reader_(parameters), reason_("no scan yet") {}

std::optional<AvoiderCommand> Avoider::onScan(const LaserScan2& scan, Time now) {
  observe(now);
  if (!enabled()) return std::nullopt;
  around_ = reader_.read(scan);
  has_scan_ = true;
  scan_stamp_ = scan.stamp;
  scan_received_ = now;
  if (!around_.fault.empty()) ++faults_;
  decide(now);
  return makeOutput();
}

std::optional<AvoiderCommand> Avoider::onBadScan(const std::string& why, Time now) {
  observe(now);
  if (!enabled()) return std::nullopt;
  around_ = {};
  around_.fault = why;
  has_scan_ = true;
  scan_stamp_ = scan_received_ = now;
  ++faults_;
  decide(now);
  return makeOutput();
}

std::optional<AvoiderCommand> Avoider::update(Time now) {
  observe(now);
  if (!enabled()) return std::nullopt;
  decide(now);
  return makeOutput();
}

std::optional<AvoiderCommand> Avoider::tick(Time now) {
  update(now);
  if (!enabled()) return std::nullopt;
  return last_;
}

std::optional<AvoiderCommand> Avoider::setEnabled(bool enable, Time now) {
  observe(now);
  if (enable == enabled()) return std::nullopt;
  has_scan_ = false;
  around_ = {};
  enter(enable ? AvoiderState::kWaiting : AvoiderState::kIdle, enable ? "no scan yet" : "switched off", now);
  last_ = command();
  return last_;
}

void Avoider::observe(Time now) {
  const bool jumped_back = now < last_now_;
  last_now_ = now;
  if (!jumped_back || !enabled()) return;
  has_scan_ = false;
  around_ = {};
  enter(AvoiderState::kWaiting, "the clock jumped: no scan since", now);
}

bool Avoider::ahead() const { return around_.obstacleDistance() < distances_.stop || around_.lane() < distances_.stop; }

bool Avoider::clear() const {
  return around_.obstacleDistance() > distances_.clear && around_.lane() >= distances_.stop;
}

void Avoider::fault(const std::string& why) {
  if (state_ != AvoiderState::kFault || reason_ != why) enter(AvoiderState::kFault, why, last_now_);
}

void Avoider::decide(Time now) {
  if (!has_scan_) return;
  if (!around_.fault.empty()) return fault(around_.fault);
  const Duration max_age = fromSeconds(parameters_.max_scan_age);
  if (now - scan_received_ > max_age) return fault("no scan arrives");
  if (now - scan_stamp_ > max_age) return fault("the scan is old");
  if (scan_stamp_ - now > max_age) return fault("the scan is from the future");
  if (state_ == AvoiderState::kReverse || state_ == AvoiderState::kRotate) return recover(now);
  if (state_ == AvoiderState::kStuck && !clear()) return;
  if (ahead()) return startEpisode(now);
  if (state_ != AvoiderState::kClear) enter(AvoiderState::kClear, "nothing near ahead", now);
}

void Avoider::startEpisode(Time now) {
  // If only the lane outside of the sectors is blocked, its two sides decide: the sectors do not contain that obstacle.
  const bool by_lane = around_.obstacleDistance() >= distances_.stop;
  const bool left = by_lane ? around_.lane_left > around_.lane_right : around_.front_left > around_.front_right;
  turn_ = left ? 1 : -1;
  cycle_ = 0;
  ++episodes_;
  startCycle(now);
}

void Avoider::startCycle(Time now) {
  ++cycle_;
  if (rearFree() && parameters_.reverse_time > 0.0) {
    return enter(AvoiderState::kReverse, "obstacle ahead: backing up", now);
  }
  turnAway(now, "obstacle ahead, and no room behind: turning away");
}

void Avoider::turnAway(Time now, const std::string& reason) {
  if (turnFree()) return enter(AvoiderState::kRotate, reason, now);
  const bool may_back_up = rearFree() && parameters_.reverse_time > 0.0 && cycle_ < parameters_.max_cycles;
  if (may_back_up) return startCycle(now);
  enter(AvoiderState::kStuck, "obstacle ahead, and no room to turn or to back up", now);
}

void Avoider::recover(Time now) {
  if (clear()) return enter(AvoiderState::kClear, "nothing near ahead", now);
  const bool reversing = state_ == AvoiderState::kReverse;
  if (reversing && !rearFree()) {
    return turnAway(now, "obstacle ahead, and no room behind: turning away");
  }
  if (!reversing && !turnFree()) return turnAway(now, {});
  const double phase_time = reversing ? parameters_.reverse_time : parameters_.turn_time;
  if (now - phase_start_ + kTickSlack < fromSeconds(phase_time)) return;
  if (reversing) return turnAway(now, "obstacle ahead: turning away");
  if (cycle_ < parameters_.max_cycles) return startCycle(now);
  enter(AvoiderState::kStuck, std::to_string(cycle_) + " cycles did not free the way ahead", now);
}

void Avoider::enter(AvoiderState state, const std::string& reason, Time now) {
  state_ = state;
  reason_ = reason;
  phase_start_ = now;
  const bool recovering = state == AvoiderState::kReverse || state == AvoiderState::kRotate;
  if (!recovering) turn_ = 0;
  if (!recovering && state != AvoiderState::kStuck) cycle_ = 0;
}

AvoiderCommand Avoider::command() const {
  switch (state_) {
    case AvoiderState::kIdle:
    case AvoiderState::kClear:
      return {{0.0, 0.0}, false};
    case AvoiderState::kReverse:
      return {{-parameters_.reverse_speed, 0.0}, false};
    case AvoiderState::kRotate:
      return {{0.0, turn_ * parameters_.turn_speed}, false};
    case AvoiderState::kWaiting:
    case AvoiderState::kFault:
    case AvoiderState::kStuck:
      break;
  }
  return {{0.0, 0.0}, true};
}

std::optional<AvoiderCommand> Avoider::makeOutput() {
  const AvoiderCommand next = command();
  if (next == last_) return std::nullopt;
  last_ = next;
  return next;
}

AvoiderSnapshot Avoider::status(Time now) const {
  AvoiderSnapshot status;
  status.state = state_;
  status.reason = reason_;
  status.around = around_;
  status.turn = turn_;
  status.cycle = cycle_;
  status.episodes = episodes_;
  status.faults = faults_;
  if (has_scan_) status.scan_age = toSeconds(now - scan_stamp_);
  return status;
}

}  // namespace frontier_pilot::avoid
