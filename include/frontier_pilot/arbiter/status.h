#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::arbiter {

/// Why `cmd_vel` is what it is.
enum class ArbiterState : std::uint8_t {
  kIdle = 0,
  kDriving = 1,
  kEmergencyStop = 2,
  kClockStopped = 3,
  kContested = 4,    ///< another node could receive an emergency stop in this one's place
  kUnreachable = 5,  ///< nobody could receive an emergency stop
};
const char* toString(ArbiterState state);

/// The state of a source.
enum class SourceState : std::uint8_t {
  kDisabled = 0,
  kNeverHeard = 1,  ///< no message since the start, or since the last clear, enable or clock jump
  kStale = 2,
  kRejected = 3,  ///< its last message was not finite
  kIdle = 4,      ///< alive, but does not claim the wheels
  kReady = 5,     ///< has a fresh command, but another source holds the wheels
  kActive = 6,
};
const char* toString(SourceState state);

struct SourceStatus {
  std::string name;
  std::string topic;
  int priority = 0;
  bool enabled = true;
  bool required = false;
  SourceState state = SourceState::kNeverHeard;
  std::optional<double> age;   ///< of its last message [s], ROS time
  double rate = 0.0;           ///< messages per second of steady time, over the last second [Hz]
  std::uint64_t rejected = 0;  ///< messages refused so far
  bool ignored = false;        ///< it asks to move, but is disabled
};

/// The arbiter's state, for operators.
struct ArbiterSnapshot {
  ArbiterState state = ArbiterState::kIdle;
  std::string active_source;                 ///< the one that holds the wheels; empty: none
  std::string stop_cause;                    ///< empty: not stopped
  std::uint64_t stops = 0;                   ///< asked for so far, also those while it was stopped already
  std::string rival;                         ///< who could receive a stop in this arbiter's place; empty: nobody
  std::string unreachable;                   ///< why this arbiter could not receive a stop; empty: it could
  Twist2 command;                            ///< what was last published
  std::vector<std::string> missing_sources;  ///< required, enabled and silent
  std::vector<SourceStatus> sources;         ///< highest priority first
};

/// One sentence: which source drives, or why none does.
std::string summarize(const ArbiterSnapshot& status);

}  // namespace frontier_pilot::arbiter
