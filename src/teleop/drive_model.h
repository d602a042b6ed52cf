#pragma once

#include <array>
#include <optional>
#include <string>

#include "frontier_pilot/core/geometry.h"
#include "teleop/parameters.h"

namespace frontier_pilot::teleop {

/// The motion that a button or a key asks for.
enum class Motion { kGo, kBack, kLeft, kRight, kStop };
const char* toString(Motion motion);

/// The keys that drive, independent of the window system.
enum class DriveKey { kUp, kDown, kLeft, kRight, kW, kA, kS, kD, kSpace };
Motion motionOf(DriveKey key);

/// Why no motion is accepted; `kNone`: it is accepted.
enum class DriveLock { kNone, kManualOff, kArbiterSilent, kEmergencyStop };
const char* toString(DriveLock lock);

/// Converts presses and releases into the manual set-point, in the base frame [m/s], [rad/s]. [GUI-1] [GUI-4]
///
/// Without hold-to-run a press adds one step, and the set-point stays until it is changed; it is counted in whole
/// steps, so that as many presses back return it to exactly zero. With hold-to-run the robot moves only while a key or
/// button is held.
class DriveModel {
 public:
  explicit DriveModel(const TeleopParameters& parameters);

  void press(Motion motion);
  void release(Motion motion);
  /// Releases everything: the window lost the focus or the pointer. Stops the robot in hold-to-run mode only.
  void releaseAll();
  /// Sets the set-point to zero, in both modes; a key that is still held counts again only after a new press.
  void stop();

  /// Changing the mode stops the robot.
  void setHoldToRun(bool hold);
  bool holdToRun() const { return hold_; }
  /// While locked the set-point is zero and presses are ignored.
  void setLock(DriveLock lock);
  DriveLock lock() const { return lock_; }

  /// Tells which source of the arbiter holds the wheels (empty: none). When an autonomous source takes them or gives
  /// them back the set-point is reset to zero, so that the robot does not drive off by an old one, and presses are
  /// ignored while it has them; the avoider does not count as such a source. One that `yields`, because manual has
  /// priority over it, takes the wheels only from a hand that is silent: the set-point is reset then, and a press takes
  /// them back. True if a set-point that was not zero was reset.
  bool setDriver(const std::string& source, bool yields = false);
  /// Whether a source drives that does not yield.
  bool machineDrives() const { return driver_ == Driver::kMachine; }

  Twist2 setPoint() const;

 private:
  static constexpr std::size_t kDirections = 4;
  enum class Driver { kHand, kYieldingMachine, kMachine };

  void step(Motion motion);

  TeleopParameters parameters_;
  bool hold_;
  DriveLock lock_ = DriveLock::kNone;
  int linear_steps_ = 0;
  int angular_steps_ = 0;
  std::array<int, kDirections> held_{};  ///< how many keys and buttons hold each direction
  Driver driver_ = Driver::kHand;        ///< also if nobody drives
};

}  // namespace frontier_pilot::teleop
