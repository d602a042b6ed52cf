#pragma once

#include <array>
#include <optional>
#include <string>

#include "frontier_pilot/core/geometry.h"
#include "teleop/parameters.h"

namespace frontier_pilot::teleop {

/// What a button or a key asks for.
enum class Motion { kGo, kBack, kLeft, kRight, kStop };
const char* toString(Motion motion);

/// The keys that drive, whatever the window system calls them.
enum class DriveKey { kUp, kDown, kLeft, kRight, kW, kA, kS, kD, kSpace };
Motion motionOf(DriveKey key);

/// Why no motion is accepted; `kNone` is the only one that lets it pass.
enum class DriveLock { kNone, kManualOff, kEmergencyStop };
const char* toString(DriveLock lock);

/// Turns presses and releases into the manual set-point, in the base frame [m/s], [rad/s]. [GUI-1] [GUI-4]
///
/// Without hold-to-run a press adds one step, and the set-point stays until it is changed; it is counted in whole
/// steps, so that as many presses back end at zero exactly. With hold-to-run the robot moves only while something is
/// held.
class DriveModel {
 public:
  explicit DriveModel(const TeleopParameters& parameters);

  void press(Motion motion);
  void release(Motion motion);
  /// Nothing is held any more: the window lost the focus or the pointer. Ends the motion of hold-to-run only.
  void releaseAll();
  /// Zero at once, in both ways of driving; what is still held counts again only after a new press.
  void stop();

  /// Changing the way of driving stops.
  void setHoldToRun(bool hold);
  bool holdToRun() const { return hold_; }
  /// While locked the set-point is zero and presses are ignored.
  void setLock(DriveLock lock);
  DriveLock lock() const { return lock_; }

  /// Tells who holds the wheels (a source of the arbiter, empty: nobody). When a machine takes or gives back the wheels
  /// the set-point is dropped, so that the robot does not run off by itself; the avoider only interrupts.
  /// True if that dropped a set-point that was not zero.
  bool setDriver(const std::string& source);
  bool machineDrives() const { return machine_drives_; }

  Twist2 setPoint() const;

 private:
  static constexpr std::size_t kDirections = 4;

  void step(Motion motion);

  TeleopParameters parameters_;
  bool hold_;
  DriveLock lock_ = DriveLock::kNone;
  int linear_steps_ = 0;
  int angular_steps_ = 0;
  std::array<int, kDirections> held_{};  ///< how many keys and buttons hold each direction
  bool machine_drives_ = false;
};

}  // namespace frontier_pilot::teleop
