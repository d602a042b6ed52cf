#pragma once

#include <cstdint>

#include "frontier_pilot/core/clock_watch.h"

namespace frontier_pilot {

enum class TrustChange { kNone, kLost, kRegained };

/// Whether ROS time can be relied on: not after a jump, until it has run without another one for `settling_time` of
/// steady time. Discard stamped data at both changes: data that arrives in between may have stamps of either time.
class ClockTrust {
 public:
  explicit ClockTrust(const ClockPace& pace = kSimulatedPace, Duration settling_time = std::chrono::milliseconds(500))
      : watch_(Duration::max(), pace), settling_time_(settling_time) {}

  /// To be called frequently, with steady time that never decreases.
  TrustChange observe(const Instant& now);
  bool trusted() const { return trusted_; }
  std::uint64_t jumps() const { return jumps_; }
  /// The change of ROS time in the jump that last lost the trust [s]; negative: backward. Further jumps before it is
  /// regained do not change it.
  double jump() const { return jump_; }
  /// When the latest jump was, if there was one.
  SteadyTime lastJumped() const { return jumped_; }

 private:
  ClockWatch watch_;
  Duration settling_time_;
  bool trusted_ = true;
  std::uint64_t jumps_ = 0;
  double jump_ = 0.0;
  SteadyTime jumped_{};
};

}  // namespace frontier_pilot
