#include "frontier_pilot/arbiter/arbiter.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace frontier_pilot::arbiter {
namespace {

const ArbiterParameters& checked(const ArbiterParameters& parameters) {
  Problems problems;
  parameters.check(problems);
  if (!problems.empty()) throw std::invalid_argument("arbiter: " + problems.front());
  return parameters;
}

}  // namespace

Arbiter::Arbiter(const ArbiterParameters& parameters)
    : parameters_(checked(parameters)),
      sources_(parameters.sources.size()),
      order_(parameters.sources.size()),
      clock_(fromSeconds(parameters.clock_stall_time)) {
  std::vector<std::size_t> by_priority(sources_.size());
  std::iota(by_priority.begin(), by_priority.end(), std::size_t{0});
  std::sort(by_priority.begin(), by_priority.end(), [&](std::size_t a, std::size_t b) {
    return parameters_.sources[a].priority > parameters_.sources[b].priority;
  });
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const std::size_t index = by_priority[i];
    order_[index] = i;
    sources_[i].config = index;
    sources_[i].enabled = parameters_.sources[index].enabled;
    sources_[i].timeout = fromSeconds(parameters_.sources[index].timeout);
  }
}

Arbiter::Source& Arbiter::at(std::size_t source) { return sources_[order_.at(source)]; }

std::optional<std::size_t> Arbiter::find(const std::string& source) const {
  for (std::size_t i = 0; i < parameters_.sources.size(); ++i) {
    if (parameters_.sources[i].name == source) return i;
  }
  return std::nullopt;
}

std::optional<Twist2> Arbiter::onCommand(std::size_t source, const Twist2& command, const Instant& now, bool hold) {
  observe(now);
  Source& speaker = at(source);
  store(speaker, command, hold, now);
  const Decision decision = decide(now.ros);
  return makeOutput(decision, isWinner(speaker, decision));
}

std::optional<Twist2> Arbiter::update(const Instant& now) {
  observe(now);
  return makeOutput(decide(now.ros), false);
}

std::optional<Twist2> Arbiter::tick(const Instant& now) {
  observe(now);
  measureRates(now.steady);
  const Decision decision = decide(now.ros);
  return makeOutput(decision, !decision.winner);
}

void Arbiter::observe(const Instant& now) {
  if (clock_.observe(now) == ClockEvent::kRunning) return;
  forgetAll();
  for (Source& source : sources_) source.last_message.reset();
}

void Arbiter::forget(Source& source) {
  source.command.reset();
  source.rejected_last = false;
  source.forgotten = true;
}

void Arbiter::forgetAll() {
  for (Source& source : sources_) forget(source);
}

void Arbiter::store(Source& source, const Twist2& command, bool hold, const Instant& now) {
  ++source.received;
  source.last_message = now.ros;
  if (!command.isFinite()) {
    ++source.rejected;
    forget(source);
    source.rejected_last = true;
    return;
  }
  if (!command.isZero()) source.last_motion = now.steady;
  // While ROS time stands still the age of a command is unknown: it must not be used once time goes on.
  if (!source.enabled || clock_.stopped()) return;
  source.command = clamp(command, parameters_.robot.limits);
  source.command_time = now.ros;
  source.hold = hold;
  source.rejected_last = false;
  source.forgotten = false;
}

bool Arbiter::alive(const Source& source, Time now) const {
  return source.enabled && source.command && now - source.command_time <= source.timeout;
}

bool Arbiter::claims(const Source& source, Time now) const {
  if (!alive(source, now)) return false;
  return source.hold || !config(source).zero_means_idle || !source.command->isZero();
}

Arbiter::Decision Arbiter::decide(Time now) const {
  if (latched_) return {ArbiterState::kEmergencyStop, std::nullopt, {}};
  if (!unreachable_.empty()) return {ArbiterState::kUnreachable, std::nullopt, {}};
  if (contested()) return {ArbiterState::kContested, std::nullopt, {}};
  if (clock_.stopped()) return {ArbiterState::kClockStopped, std::nullopt, {}};
  bool forward_allowed = true;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Source& source = sources_[i];
    if (claims(source, now)) {
      Twist2 command = *source.command;
      if (!forward_allowed) command.linear = std::min(command.linear, 0.0);
      return {ArbiterState::kDriving, i, command};
    }
    if (config(source).required && source.enabled && !alive(source, now)) forward_allowed = false;
  }
  return {ArbiterState::kIdle, std::nullopt, {}};
}

bool Arbiter::isWinner(const Source& source, const Decision& decision) const {
  return decision.winner && &source == &sources_[*decision.winner];
}

std::optional<Twist2> Arbiter::makeOutput(const Decision& decision, bool always) {
  const bool changed = decision.winner != last_.winner || decision.command != last_.command;
  last_ = decision;
  if (!changed && !always) return std::nullopt;
  return decision.command;
}

ArbiterAnswer Arbiter::setEnabled(std::size_t source, bool enabled, const Instant& now) {
  observe(now);
  Source& switched = at(source);
  const std::string text = config(switched).name + (enabled ? " enabled" : " disabled");
  if (switched.enabled == enabled) return {true, text + " already: nothing changed", update(now)};
  switched.enabled = enabled;
  forget(switched);
  return {true, text, update(now)};
}

ArbiterAnswer Arbiter::stop(const std::string& cause, const Instant& now) {
  observe(now);
  last_stop_ = now.steady;
  ++stops_;
  const bool already = latched_;
  if (!already) stop_cause_ = cause;
  latched_ = true;
  const std::optional<Twist2> zero = makeOutput(decide(now.ros), true);
  return {true, already ? "stopped already: " + stop_cause_ : "stopped", zero};
}

ArbiterAnswer Arbiter::clear(SteadyTime requested, const Instant& now) {
  observe(now);
  if (!latched_) return {true, "not stopped: nothing changed", update(now)};
  const std::string refusal = refusalToClear(requested, now);
  if (!refusal.empty()) return {false, "refused: " + refusal, update(now)};
  latched_ = false;
  stop_cause_.clear();
  forgetAll();
  return {true, "cleared: the robot stands still until a new command arrives", update(now)};
}

std::optional<Twist2> Arbiter::contest(const std::string& rival, const Instant& now) {
  observe(now);
  if (rival == rival_) return std::nullopt;
  rival_ = rival;
  if (parameters_.stand_when_contested) forgetAll();
  return makeOutput(decide(now.ros), true);
}

std::optional<Twist2> Arbiter::setUnreachable(const std::string& why, const Instant& now) {
  observe(now);
  if (why == unreachable_) return std::nullopt;
  unreachable_ = why;
  forgetAll();
  return makeOutput(decide(now.ros), true);
}

std::optional<Twist2> Arbiter::setLimits(const RobotLimits& limits, const Instant& now) {
  parameters_.robot.limits = limits;
  for (Source& source : sources_) {
    if (source.command) source.command = clamp(*source.command, limits);
  }
  return update(now);
}

std::string Arbiter::refusalToClear(SteadyTime requested, const Instant& now) const {
  if (last_stop_ >= requested) return "a stop was given while this call was under way";
  for (const Source& source : sources_) {
    if (!source.enabled || !source.last_motion) continue;
    const double age = toSeconds(now.steady - *source.last_motion);
    if (age <= parameters_.clear_quiet_time) {
      return config(source).name + " asked to move " + std::to_string(static_cast<int>(age * 1000.0)) +
             " ms ago; end what drives it, then clear";
    }
  }
  return {};
}

}  // namespace frontier_pilot::arbiter
