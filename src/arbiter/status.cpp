#include "frontier_pilot/arbiter/status.h"

#include "frontier_pilot/arbiter/arbiter.h"

namespace frontier_pilot::arbiter {
namespace {

constexpr Duration kRateWindow = std::chrono::seconds(1);
/// For how long a disabled source is said to ask for the wheels after it last asked to move: in a recovery, for
/// instance, the navigator stands for moments.
constexpr Duration kIgnoredFor = std::chrono::seconds(2);

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// The source that asks to move although it is disabled; empty if none does.
std::string whoIsIgnored(const ArbiterSnapshot& status) {
  for (const SourceStatus& source : status.sources)
    if (source.ignored) return source.name + " asks to move, but is disabled (set_" + source.name + "_enabled true)";
  return {};
}

std::string whoDrives(const ArbiterSnapshot& status) {
  const std::string ignored = whoIsIgnored(status);
  switch (status.state) {
    case ArbiterState::kEmergencyStop:
      return "emergency stop: " + status.stop_cause;
    case ArbiterState::kClockStopped:
      return "ROS time stands still: stopped";
    case ArbiterState::kContested:
      return status.rival + " could receive an emergency stop in this arbiter's place: stopped";
    case ArbiterState::kUnreachable:
      return "no emergency stop can be called, because " + status.unreachable + ": stopped";
    case ArbiterState::kDriving:
      if (!status.command.isZero()) return status.active_source + " drives";
      return status.active_source + " holds the robot still" + (ignored.empty() ? "" : "; " + ignored);
    case ArbiterState::kIdle:
      break;
  }
  return (ignored.empty() ? "nobody asks for the wheels" : ignored) + ": stopped";
}

}  // namespace

const char* toString(ArbiterState state) {
  constexpr const char* kNames[] = {"idle", "driving", "emergency stop", "clock stopped", "contested", "unreachable"};
  return kNames[static_cast<int>(state)];
}

const char* toString(SourceState state) {
  constexpr const char* kNames[] = {"disabled", "never heard", "stale", "rejected", "idle", "ready", "active"};
  return kNames[static_cast<int>(state)];
}

std::string summarize(const ArbiterSnapshot& status) {
  std::string text = whoDrives(status);
  if (!status.missing_sources.empty()) {
    text += "; " + joined(status.missing_sources) + " is required but silent: no forward motion below it";
  }
  return text;
}

void Arbiter::measureRates(SteadyTime now) {
  const Duration elapsed = now - rate_window_;
  if (elapsed < kRateWindow) return;
  for (Source& source : sources_) {
    source.rate = static_cast<double>(source.received - source.received_at_window) / toSeconds(elapsed);
    source.received_at_window = source.received;
  }
  rate_window_ = now;
}

SourceState Arbiter::stateOf(const Source& source, const Decision& decision, Time now) const {
  if (!source.enabled) return SourceState::kDisabled;
  if (source.rejected_last) return SourceState::kRejected;
  if (source.forgotten) return SourceState::kNeverHeard;
  if (!alive(source, now)) return SourceState::kStale;
  if (isWinner(source, decision)) return SourceState::kActive;
  return claims(source, now) ? SourceState::kReady : SourceState::kIdle;
}

SourceStatus Arbiter::statusOf(const Source& source, const Decision& decision, const Instant& now) const {
  const SourceParameters& settings = config(source);
  SourceStatus status;
  status.name = settings.name;
  status.topic = settings.topic;
  status.priority = settings.priority;
  status.enabled = source.enabled;
  status.required = settings.required;
  status.state = stateOf(source, decision, now.ros);
  if (source.last_message) status.age = toSeconds(now.ros - *source.last_message);
  status.rate = source.rate;
  status.rejected = source.rejected;
  status.ignored = !source.enabled && source.last_motion && now.steady - *source.last_motion <= kIgnoredFor;
  return status;
}

ArbiterSnapshot Arbiter::status(const Instant& now) const {
  const Decision decision = decide(now.ros);
  ArbiterSnapshot status;
  status.state = decision.state;
  if (decision.winner) status.active_source = config(sources_[*decision.winner]).name;
  status.stop_cause = stop_cause_;
  status.stops = stops_;
  status.rival = rival_;
  status.unreachable = unreachable_;
  status.command = last_.command;
  for (const Source& source : sources_) {
    status.sources.push_back(statusOf(source, decision, now));
    const bool missing = config(source).required && source.enabled && !alive(source, now.ros);
    if (missing) status.missing_sources.push_back(config(source).name);
  }
  return status;
}

}  // namespace frontier_pilot::arbiter
