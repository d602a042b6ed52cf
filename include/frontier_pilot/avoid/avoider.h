#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "frontier_pilot/avoid/parameters.h"
#include "frontier_pilot/avoid/sector_reader.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::avoid {

enum class AvoiderState : std::uint8_t {
  kIdle = 0,     ///< switched off: publishes nothing
  kWaiting = 1,  ///< no scan since it was switched on, or since the clock jumped back: holds
  kClear = 2,    ///< nothing near: a heartbeat of zeros that leaves the wheels to the others
  kReverse = 3,
  kRotate = 4,
  kFault = 5,  ///< the scan cannot be trusted: holds
  kStuck = 6,  ///< `max_cycles` did not help: holds
};
const char* toString(AvoiderState state);

/// What the avoider asks of the arbiter.
struct AvoiderCommand {
  Twist2 twist;
  bool hold = false;  ///< zero on purpose: it claims the wheels although it is zero
};
inline bool operator==(const AvoiderCommand& a, const AvoiderCommand& b) {
  return a.twist == b.twist && a.hold == b.hold;
}

struct AvoiderSnapshot {
  AvoiderState state = AvoiderState::kWaiting;
  std::string reason;
  SectorDistances around;
  int turn = 0;  ///< +1 left, -1 right, 0 not recovering
  int cycle = 0;
  std::uint32_t episodes = 0;
  std::uint64_t faults = 0;
  std::optional<double> scan_age;  ///< [s], ROS time
};

/// Last-resort avoidance by the laser scan: backs up and turns away from what is near ahead.
/// A robot whose corners would hit something in a turn backs up further, or holds where it cannot.
///
/// The direction of a turn is chosen once for an episode, that is until `clear_distance` is free again. Every method is
/// one input at one moment of ROS time and gives what has to be published at once, if anything has. A backward jump of
/// the clock makes it wait for a new scan. Requirements: docs/requirements.md, AVO-1 to AVO-6.
class Avoider {
 public:
  /// Throws std::invalid_argument when the parameters do not pass their own check.
  explicit Avoider(const AvoiderParameters& parameters);

  std::optional<AvoiderCommand> onScan(const LaserScan2& scan, Time now);
  /// A scan came that could not be read at all.
  std::optional<AvoiderCommand> onBadScan(const std::string& why, Time now);
  /// Lets time pass: gives what that has changed.
  std::optional<AvoiderCommand> update(Time now);
  /// The same, and the heartbeat. To be called at 10 Hz.
  std::optional<AvoiderCommand> tick(Time now);
  /// Switching off gives one zero, and then nothing any more; switching on waits for a new scan. [AVO-6]
  std::optional<AvoiderCommand> setEnabled(bool enabled, Time now);

  bool enabled() const { return state_ != AvoiderState::kIdle; }
  AvoiderState state() const { return state_; }
  AvoiderSnapshot status(Time now) const;

 private:
  void observe(Time now);
  void fault(const std::string& why);
  void decide(Time now);
  void startEpisode(Time now);
  void startCycle(Time now);
  void recover(Time now);
  void enter(AvoiderState state, const std::string& reason, Time now);
  void turnAway(Time now, const std::string& reason);
  bool rearFree() const { return around_.rear >= distances_.rear_stop; }
  bool turnFree() const { return around_.nearest >= distances_.turn; }
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
  Time scan_stamp_, scan_received_;
  Time last_now_;
  Time phase_start_;
  int turn_ = 0, cycle_ = 0;
  std::uint32_t episodes_ = 0;
  std::uint64_t faults_ = 0;
  AvoiderCommand last_;
};

}  // namespace frontier_pilot::avoid
