#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "frontier_pilot/avoid/parameters.h"
#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::avoid {

enum class AvoiderState : std::uint8_t {
  kIdle = 0,     ///< switched off: publishes nothing
  kWaiting = 1,  ///< no scan since it was switched on, or since the clock jumped back: holds the robot at zero
  kClear = 2,    ///< nothing near: a heartbeat of zeros that leaves the wheels to other sources
  kReverse = 3,
  kRotate = 4,
  kFault = 5,  ///< the scan cannot be trusted: holds the robot at zero
  kStuck = 6,  ///< `max_cycles` did not help, or no room to turn or back up: holds the robot at zero
};
const char* toString(AvoiderState state);

/// What the avoider sends to the arbiter.
struct AvoiderCommand {
  Twist2 twist;
  bool hold = false;  ///< the command claims the wheels although it is zero
};
inline bool operator==(const AvoiderCommand& a, const AvoiderCommand& b) {
  return a.twist == b.twist && a.hold == b.hold;
}

/// The nearest obstacles around the base in one scan: distances from the base's origin [m]; infinite if none in range.
/// In the lane of a robot that is no disc they count along the lane, so that its corners have as much room as its
/// middle.
struct SectorDistances {
  static constexpr double kNothing = std::numeric_limits<double>::infinity();

  double front_left = kNothing;
  double front_right = kNothing;
  double rear = kNothing;        ///< in the rear sector, or in the lane behind the body
  bool sees_rear = false;        ///< valid beams look along the lane behind the body
  double lane_left = kNothing;   ///< in the lane ahead of the body, also outside of the front sectors, on the left
  double lane_right = kNothing;  ///< the same on the right
  double nearest = kNothing;     ///< in any direction
  std::string fault;             ///< why the scan cannot be trusted; empty if it can

  /// The smaller of the two sector minima. [AVO-1]
  double obstacleDistance() const { return std::min(front_left, front_right); }
  double lane() const { return std::min(lane_left, lane_right); }
};

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

/// Last-resort obstacle avoidance by the laser scan: backs up and turns away from an obstacle near ahead.
/// A robot whose corners would hit something in a turn backs up further, or stands still if it cannot.
///
/// It does not back up where no valid beam looks: with a scanner that does not see all of the lane behind the body it
/// turns.
///
/// The direction of a turn is chosen once per episode, which lasts until `clear_distance` is free again; a fault of the
/// scan in between holds the robot, and the episode then goes on where it was. Each method takes one input at one
/// moment of ROS time and returns what must be published at once, if anything. After a backward jump of the clock it
/// waits for a new scan. Requirements: docs/requirements.md, AVO-1 to AVO-6.
class Avoider {
 public:
  /// Throws std::invalid_argument when the parameters do not pass their own check.
  explicit Avoider(const AvoiderParameters& parameters);
  ~Avoider();
  Avoider(Avoider&&) noexcept;
  Avoider& operator=(Avoider&&) noexcept;
  Avoider(const Avoider&) = delete;
  Avoider& operator=(const Avoider&) = delete;

  std::optional<AvoiderCommand> onScan(const LaserScan2& scan, Time now);
  /// A scan arrived that could not be read at all.
  std::optional<AvoiderCommand> onBadScan(const std::string& why, Time now);
  /// Lets time pass: returns a command only if that has changed it.
  std::optional<AvoiderCommand> update(Time now);
  /// The same, but always returns the current command, as a heartbeat. To be called at 10 Hz.
  std::optional<AvoiderCommand> tick(Time now);
  /// Switching off returns one zero, and nothing from then on; switching on waits for a new scan. [AVO-6]
  std::optional<AvoiderCommand> setEnabled(bool enabled, Time now);

  /// While it rests it begins no recovery, and one that it has begun ends; what has to be held at zero is held. It has
  /// to rest from an emergency stop on until another source drives the robot, so that a clear moves nothing. `why` it
  /// rests is part of the status if an obstacle is ahead; empty if it does not rest. [ARB-8]
  std::optional<AvoiderCommand> setResting(const std::string& why, Time now);

  /// Other parameters, which take effect at the next update. Throws std::invalid_argument when they do not pass their
  /// own check; the old ones then stay in force.
  void setParameters(const AvoiderParameters& parameters);

  bool enabled() const;
  AvoiderState state() const;
  AvoiderSnapshot status(Time now) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::avoid
