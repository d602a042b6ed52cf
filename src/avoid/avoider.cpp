#include "frontier_pilot/avoid/avoider.h"

#include <stdexcept>
#include <utility>

#include "avoid/sector_reader.h"

namespace frontier_pilot::avoid {
namespace {

/// Ticks may come slightly early or late; without this slack an early one would prolong a phase by a whole tick.
constexpr Duration kTickSlack = std::chrono::milliseconds(10);

constexpr const char* kNothingAhead = "nothing near ahead";

const AvoiderParameters& checked(const AvoiderParameters& parameters) {
  Problems problems;
  parameters.check(problems);
  if (!problems.empty()) throw std::invalid_argument("avoider: " + problems.front());
  return parameters;
}

}  // namespace

/// The state machine; decide() enters the state that follows from the last scan and the time.
class Avoider::Impl {
 public:
  explicit Impl(const AvoiderParameters& parameters)
      : parameters_(checked(parameters)), distances_(parameters), reader_(parameters), reason_("no scan yet") {}

  std::optional<AvoiderCommand> onScan(const LaserScan2& scan, Time now);
  std::optional<AvoiderCommand> onBadScan(const std::string& why, Time now);
  std::optional<AvoiderCommand> update(Time now);
  std::optional<AvoiderCommand> tick(Time now);
  std::optional<AvoiderCommand> setEnabled(bool enabled, Time now);
  std::optional<AvoiderCommand> setResting(const std::string& why, Time now) {
    why_rests_ = why;
    return update(now);
  }
  void setParameters(const AvoiderParameters& parameters);

  bool enabled() const { return state_ != AvoiderState::kIdle; }
  AvoiderState state() const { return state_; }
  AvoiderSnapshot status(Time now) const;

 private:
  void observe(Time now);
  std::optional<AvoiderCommand> take(SectorDistances around, Time stamp);
  void fault(const std::string& why);
  void decide(Time now);
  void beClear(const std::string& reason, Time now);
  void startEpisode(Time now);
  void startCycle(Time now);
  void recover(Time now);
  void enter(AvoiderState state, const std::string& reason, Time now);
  void resume(Time now);
  void turnAway(Time now, const std::string& reason);
  bool rearFree() const { return around_.sees_rear && around_.rear >= distances_.rear_stop; }
  std::string noReversing() const;
  bool turnFree() const { return around_.nearest >= distances_.turn; }
  bool isRecovering() const { return state_ == AvoiderState::kReverse || state_ == AvoiderState::kRotate; }
  bool ahead() const;
  bool clear() const;
  AvoiderCommand command() const;
  std::optional<AvoiderCommand> makeOutput();

  AvoiderParameters parameters_;
  AvoiderDistances distances_;
  SectorReader reader_;
  AvoiderState state_ = AvoiderState::kWaiting;
  std::string reason_;
  SectorDistances around_;
  bool has_scan_ = false;
  std::string why_rests_;  ///< and begins no recovery; empty: it does not rest
  Time scan_stamp_, scan_received_;
  Time last_now_;
  Time phase_start_;
  int turn_ = 0, cycle_ = 0;  ///< kept during a fault, which interrupts an episode but does not end it
  struct Interrupted {
    AvoiderState state;
    std::string reason;
    Duration phase;  ///< how long it had lasted
  };
  std::optional<Interrupted> interrupted_;  ///< by the present fault
  std::uint32_t episodes_ = 0;
  std::uint64_t faults_ = 0;
  AvoiderCommand last_;
};

std::optional<AvoiderCommand> Avoider::Impl::onScan(const LaserScan2& scan, Time now) {
  observe(now);
  return enabled() ? take(reader_.read(scan), scan.stamp) : std::nullopt;
}

std::optional<AvoiderCommand> Avoider::Impl::onBadScan(const std::string& why, Time now) {
  observe(now);
  SectorDistances nothing;
  nothing.fault = why;
  return enabled() ? take(std::move(nothing), now) : std::nullopt;
}

std::optional<AvoiderCommand> Avoider::Impl::take(SectorDistances around, Time stamp) {
  around_ = std::move(around);
  has_scan_ = true;
  scan_stamp_ = stamp;
  scan_received_ = last_now_;
  if (!around_.fault.empty()) ++faults_;
  decide(last_now_);
  return makeOutput();
}

std::optional<AvoiderCommand> Avoider::Impl::update(Time now) {
  observe(now);
  if (!enabled()) return std::nullopt;
  decide(now);
  return makeOutput();
}

std::optional<AvoiderCommand> Avoider::Impl::tick(Time now) {
  update(now);
  return enabled() ? std::optional<AvoiderCommand>(last_) : std::nullopt;
}

std::optional<AvoiderCommand> Avoider::Impl::setEnabled(bool enable, Time now) {
  observe(now);
  if (enable == enabled()) return std::nullopt;
  has_scan_ = false;
  around_ = {};
  enter(enable ? AvoiderState::kWaiting : AvoiderState::kIdle, enable ? "no scan yet" : "switched off", now);
  return last_ = command();
}

void Avoider::Impl::setParameters(const AvoiderParameters& parameters) {
  parameters_ = checked(parameters);
  distances_ = AvoiderDistances(parameters_);
  reader_ = SectorReader(parameters_);
}

void Avoider::Impl::observe(Time now) {
  const bool jumped_back = now < last_now_;
  last_now_ = now;
  if (!jumped_back || !enabled()) return;
  has_scan_ = false;
  around_ = {};
  enter(AvoiderState::kWaiting, "the clock jumped: no scan since", now);
}

bool Avoider::Impl::ahead() const {
  return around_.obstacleDistance() < distances_.stop || around_.lane() < distances_.stop;
}

bool Avoider::Impl::clear() const {
  return around_.obstacleDistance() > distances_.clear && around_.lane() >= distances_.stop;
}

void Avoider::Impl::fault(const std::string& why) {
  if (state_ == AvoiderState::kFault && reason_ == why) return;
  if (state_ != AvoiderState::kFault) interrupted_ = Interrupted{state_, reason_, last_now_ - phase_start_};
  enter(AvoiderState::kFault, why, last_now_);
}

/// After a fault, goes on with the episode that it interrupted, as long as the way ahead is not clear.
void Avoider::Impl::resume(Time now) {
  const std::optional<Interrupted> before = std::exchange(interrupted_, std::nullopt);
  const bool was_avoiding = before && (before->state == AvoiderState::kReverse ||
                                       before->state == AvoiderState::kRotate || before->state == AvoiderState::kStuck);
  if (was_avoiding && !clear()) enter(before->state, before->reason, now - before->phase);
}

void Avoider::Impl::decide(Time now) {
  if (!has_scan_) return;
  if (!around_.fault.empty()) return fault(around_.fault);
  const Duration max_age = fromSeconds(parameters_.max_scan_age);
  if (now - scan_received_ > max_age) return fault("no scan arrives");
  if (now - scan_stamp_ > max_age) return fault("the scan is old");
  if (scan_stamp_ - now > max_age) return fault("the scan is from the future");
  resume(now);
  if (!why_rests_.empty() && (isRecovering() || ahead())) return beClear("obstacle ahead: " + why_rests_, now);
  if (isRecovering()) return recover(now);
  if (state_ == AvoiderState::kStuck && !clear()) return;
  if (ahead()) return startEpisode(now);
  beClear(kNothingAhead, now);
}

void Avoider::Impl::beClear(const std::string& reason, Time now) {
  if (state_ != AvoiderState::kClear || reason_ != reason) enter(AvoiderState::kClear, reason, now);
}

void Avoider::Impl::startEpisode(Time now) {
  // If only the lane is blocked, its two sides decide: the sectors do not contain that obstacle, or do not count it as
  // near.
  const bool by_lane = around_.obstacleDistance() >= distances_.stop;
  const bool left = by_lane ? around_.lane_left > around_.lane_right : around_.front_left > around_.front_right;
  turn_ = left ? 1 : -1;
  cycle_ = 0;
  ++episodes_;
  startCycle(now);
}

void Avoider::Impl::startCycle(Time now) {
  ++cycle_;
  if (rearFree() && parameters_.reverse_time > 0.0) {
    return enter(AvoiderState::kReverse, "obstacle ahead: backing up", now);
  }
  turnAway(now, noReversing());
}

std::string Avoider::Impl::noReversing() const {
  const char* why = around_.sees_rear ? "no room behind" : "the scan does not show all that is behind";
  return std::string("obstacle ahead, and ") + why + ": turning away";
}

void Avoider::Impl::turnAway(Time now, const std::string& reason) {
  if (turnFree()) return enter(AvoiderState::kRotate, reason, now);
  const bool may_back_up = rearFree() && parameters_.reverse_time > 0.0 && cycle_ < parameters_.max_cycles;
  if (may_back_up) return startCycle(now);
  enter(AvoiderState::kStuck, "obstacle ahead, and no room to turn or to back up", now);
}

void Avoider::Impl::recover(Time now) {
  if (clear()) return beClear(kNothingAhead, now);
  const bool reversing = state_ == AvoiderState::kReverse;
  if (reversing && !rearFree()) return turnAway(now, noReversing());
  if (!reversing && !turnFree()) return turnAway(now, {});
  const double phase_time = reversing ? parameters_.reverse_time : parameters_.turn_time;
  if (now - phase_start_ + kTickSlack < fromSeconds(phase_time)) return;
  if (reversing) return turnAway(now, "obstacle ahead: turning away");
  if (cycle_ < parameters_.max_cycles) return startCycle(now);
  enter(AvoiderState::kStuck, std::to_string(cycle_) + " cycles did not free the way ahead", now);
}

void Avoider::Impl::enter(AvoiderState state, const std::string& reason, Time now) {
  state_ = state;
  reason_ = reason;
  phase_start_ = now;
  if (state == AvoiderState::kFault) return;
  interrupted_.reset();
  if (!isRecovering()) turn_ = 0;
  if (!isRecovering() && state != AvoiderState::kStuck) cycle_ = 0;
}

AvoiderCommand Avoider::Impl::command() const {
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

std::optional<AvoiderCommand> Avoider::Impl::makeOutput() {
  const AvoiderCommand next = command();
  if (next == last_) return std::nullopt;
  last_ = next;
  return next;
}

AvoiderSnapshot Avoider::Impl::status(Time now) const {
  AvoiderSnapshot status;
  status.state = state_;
  status.reason = reason_;
  status.around = around_;
  status.turn = state_ == AvoiderState::kFault ? 0 : turn_;
  status.cycle = cycle_;
  status.episodes = episodes_;
  status.faults = faults_;
  if (has_scan_) status.scan_age = toSeconds(now - scan_stamp_);
  return status;
}

Avoider::Avoider(const AvoiderParameters& parameters) : impl_(std::make_unique<Impl>(parameters)) {}
Avoider::~Avoider() = default;
Avoider::Avoider(Avoider&&) noexcept = default;
Avoider& Avoider::operator=(Avoider&&) noexcept = default;

std::optional<AvoiderCommand> Avoider::onScan(const LaserScan2& scan, Time now) { return impl_->onScan(scan, now); }
std::optional<AvoiderCommand> Avoider::onBadScan(const std::string& why, Time now) {
  return impl_->onBadScan(why, now);
}
std::optional<AvoiderCommand> Avoider::update(Time now) { return impl_->update(now); }
std::optional<AvoiderCommand> Avoider::tick(Time now) { return impl_->tick(now); }
std::optional<AvoiderCommand> Avoider::setEnabled(bool enable, Time now) { return impl_->setEnabled(enable, now); }
std::optional<AvoiderCommand> Avoider::setResting(const std::string& why, Time now) {
  return impl_->setResting(why, now);
}
void Avoider::setParameters(const AvoiderParameters& parameters) { impl_->setParameters(parameters); }
bool Avoider::enabled() const { return impl_->enabled(); }
AvoiderState Avoider::state() const { return impl_->state(); }
AvoiderSnapshot Avoider::status(Time now) const { return impl_->status(now); }

}  // namespace frontier_pilot::avoid
