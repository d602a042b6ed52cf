#pragma once

#include <cstdint>

#include "frontier_pilot/core/clock_watch.h"

namespace frontier_pilot {

enum class TrustChange { kNone, kLost, kRegained };

/// Whether ROS time can be relied on: not from a jump on until it has run without another one for a while of steady
/// time. Whoever keeps stamped data forgets it at both changes: what arrives between them may be of either time.
class ClockTrust {
 public:
  explicit ClockTrust(const ClockPace& pace = kSimulatedPace, Duration settling_time = std::chrono::milliseconds(500))
      : watch_(Duration::max(), pace), settling_time_(settling_time) {}

  /// To be called often, in the order of steady time.
  TrustChange observe(const Instant& now);
  bool trusted() const { return trusted_; }
  std::uint64_t jumps() const { return jumps_; }
  /// How far the first of the latest jumps in a row went [s]; negative: backward.
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
