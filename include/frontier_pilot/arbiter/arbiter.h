#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/arbiter/parameters.h"
#include "frontier_pilot/arbiter/status.h"
#include "frontier_pilot/core/clock_watch.h"
#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::arbiter {

/// The response to a service call, and what must be published on `cmd_vel` before it is sent.
struct ArbiterAnswer {
  bool success = true;
  std::string message;
  std::optional<Twist2> publish;
};

/// Decides whose velocity command reaches the base. Commands are in the base frame [m/s], [rad/s]. A source "claims the
/// wheels" while it has a fresh command that is not an idle zero; the one of highest priority then "holds the wheels".
///
/// Each method takes one input at one moment, with steady time that never decreases. The twist that it returns, if any,
/// must be published at once: the command of the highest valid source, or zero; never stale, never beyond the limits,
/// never non-finite. Requirements: docs/requirements.md, ARB-1 to ARB-9, ARB-12.
class Arbiter {
 public:
  /// Throws std::invalid_argument when the parameters do not pass their own check.
  explicit Arbiter(const ArbiterParameters& parameters);

  /// A message from source `source` (an index into the parameters' list). It is rejected if not finite. [ARB-2] [ARB-5]
  /// With `hold` the command claims the wheels even if it is zero and the source's zeros mean that it is idle.
  std::optional<Twist2> onCommand(std::size_t source, const Twist2& command, const Instant& now, bool hold = false);
  /// Lets time pass: returns a twist only if expiry or the clock has changed what is to be published.
  std::optional<Twist2> update(const Instant& now);
  /// The same, and a zero at every tick while no source holds the wheels. To be called at 20 Hz of steady time.
  /// [ARB-2]
  std::optional<Twist2> tick(const Instant& now);

  /// Enables or disables a source. Idempotent. [ARB-6]
  ArbiterAnswer setEnabled(std::size_t source, bool enabled, const Instant& now);
  /// Latches the emergency stop; always returns a zero to publish. Idempotent: the first cause is kept. [ARB-7]
  ArbiterAnswer stop(const std::string& cause, const Instant& now);
  /// To be called when the response to a stop is sent. A clear requested before that cannot know of the stop. [ARB-8]
  void answerStop(SteadyTime now) { last_stop_ = now; }
  /// Clears the emergency stop, or says why not. `requested` is when the call arrived: a stop that was answered after
  /// that takes precedence, whichever call is handled first. [ARB-8]
  ArbiterAnswer clear(SteadyTime requested, const Instant& now);

  /// `rival` is another node that could receive an emergency stop in this one's place; empty: there is none. While
  /// there is one only zeros are published, unless the parameters say otherwise, and commands received meanwhile are
  /// dropped. [ARB-12]
  std::optional<Twist2> contest(const std::string& rival, const Instant& now);

  /// `why` is the reason for which no emergency stop can be received at the moment; empty: one can. Meanwhile only
  /// zeros are published, and commands received are dropped. [ARB-12]
  std::optional<Twist2> setUnreachable(const std::string& why, const Instant& now);

  /// Other limits of the speed, from now on. Commands that are in force are reduced to them, never increased; a stop
  /// stays latched. [ARB-5] [ARB-7]
  std::optional<Twist2> setLimits(const RobotLimits& limits, const Instant& now);

  /// The arbiter before this one was asked for `earlier` stops, which count as well. One that was latched then counts
  /// once more, because that arbiter may not have lived to count it.
  void countStopsFrom(std::uint64_t earlier) { stops_ += earlier; }

  bool stopped() const { return latched_; }
  std::uint64_t stops() const { return stops_; }
  const std::string& stopCause() const { return stop_cause_; }
  const ArbiterParameters& parameters() const { return parameters_; }
  std::optional<std::size_t> find(const std::string& source) const;
  ArbiterSnapshot status(const Instant& now) const;

 private:
  struct Source {
    std::size_t config = 0;  ///< index into the parameters' list
    Duration timeout{};
    bool enabled = true;
    bool rejected_last = false;
    bool forgotten = true;  ///< no command was stored since the start, or since the last one was dropped on purpose
    std::optional<Twist2> command;
    bool hold = false;  ///< `command` claims the wheels even if it is zero
    Time command_time;
    std::optional<Time> last_message;
    std::optional<SteadyTime> last_motion;  ///< when it last asked to move, enabled or not
    std::uint64_t received = 0, rejected = 0, received_at_window = 0;
    double rate = 0.0;
  };
  struct Decision {
    ArbiterState state = ArbiterState::kIdle;
    std::optional<std::size_t> winner;  ///< index into `sources_`
    Twist2 command;
  };

  const SourceParameters& config(const Source& source) const { return parameters_.sources[source.config]; }
  Source& at(std::size_t source);
  void observe(const Instant& now);
  static void forget(Source& source);
  void forgetAll();
  void store(Source& source, const Twist2& command, bool hold, const Instant& now);
  bool contested() const { return parameters_.stand_when_contested && !rival_.empty(); }
  bool alive(const Source& source, Time now) const;
  bool claims(const Source& source, Time now) const;
  Decision decide(Time now) const;
  bool isWinner(const Source& source, const Decision& decision) const;
  std::optional<Twist2> makeOutput(const Decision& decision, bool always);
  std::string refusalToClear(SteadyTime requested, const Instant& now) const;
  void measureRates(SteadyTime now);
  SourceState stateOf(const Source& source, const Decision& decision, Time now) const;
  SourceStatus statusOf(const Source& source, const Decision& decision, const Instant& now) const;

  ArbiterParameters parameters_;
  std::vector<Source> sources_;     ///< highest priority first
  std::vector<std::size_t> order_;  ///< configuration index -> index into sources_
  ClockWatch clock_;
  bool latched_ = false;
  std::string stop_cause_;
  std::string rival_, unreachable_;
  SteadyTime last_stop_;
  std::uint64_t stops_ = 0;
  SteadyTime rate_window_;
  Decision last_;
};

}  // namespace frontier_pilot::arbiter
