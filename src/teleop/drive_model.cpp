#include "teleop/drive_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frontier_pilot::teleop {
namespace {

/// `count` + `change`, clamped to the number of steps that just reaches `limit`.
int moved(int count, int change, double step, double limit) {
  // The margin keeps 0.2 / 0.05 from needing a fifth step.
  const int most = static_cast<int>(std::ceil(limit / step - 1e-9));
  return std::clamp(count + change, -most, most);
}

bool isMachine(const std::string& source) { return !source.empty() && source != "manual" && source != "avoid"; }

}  // namespace

void TeleopParameters::check(Problems& problems) const {
  if (palette != "system" && palette != "light" && palette != "dark") {
    problems.push_back("palette: must be system, light or dark, is " + palette);
  }
}

const char* toString(Motion motion) {
  switch (motion) {
    case Motion::kGo:
      return "Go";
    case Motion::kBack:
      return "Back";
    case Motion::kLeft:
      return "Left";
    case Motion::kRight:
      return "Right";
    case Motion::kStop:
      break;
  }
  return "Stop";
}

Motion motionOf(DriveKey key) {
  switch (key) {
    case DriveKey::kUp:
    case DriveKey::kW:
      return Motion::kGo;
    case DriveKey::kDown:
    case DriveKey::kS:
      return Motion::kBack;
    case DriveKey::kLeft:
    case DriveKey::kA:
      return Motion::kLeft;
    case DriveKey::kRight:
    case DriveKey::kD:
      return Motion::kRight;
    case DriveKey::kSpace:
      break;
  }
  return Motion::kStop;
}

const char* toString(DriveLock lock) {
  switch (lock) {
    case DriveLock::kNone:
      return "";
    case DriveLock::kManualOff:
      return "manual is switched off";
    case DriveLock::kArbiterSilent:
      return "the arbiter is silent";
    case DriveLock::kEmergencyStop:
      break;
  }
  return "the emergency stop is latched";
}

DriveModel::DriveModel(const TeleopParameters& parameters) : parameters_(parameters), hold_(parameters.hold_to_run) {}

void DriveModel::press(Motion motion) {
  if (motion == Motion::kStop) return stop();
  if (lock_ != DriveLock::kNone || machineDrives()) return;
  if (hold_) {
    ++held_[static_cast<std::size_t>(motion)];
  } else {
    step(motion);
  }
}

void DriveModel::release(Motion motion) {
  if (motion == Motion::kStop) return;
  int& count = held_[static_cast<std::size_t>(motion)];
  count = std::max(0, count - 1);
}

void DriveModel::releaseAll() { held_.fill(0); }

void DriveModel::stop() {
  linear_steps_ = angular_steps_ = 0;
  releaseAll();
}

void DriveModel::setHoldToRun(bool hold) {
  if (hold == hold_) return;
  hold_ = hold;
  stop();
}

void DriveModel::setLock(DriveLock lock) {
  lock_ = lock;
  if (lock != DriveLock::kNone) stop();
}

bool DriveModel::setDriver(const std::string& source, bool yields) {
  // The avoider interrupts any source for a moment: it does not tell who drives afterwards.
  if (source == "avoid") return false;
  const Driver machine = yields ? Driver::kYieldingMachine : Driver::kMachine;
  const Driver driver = isMachine(source) ? machine : Driver::kHand;
  const Driver before = std::exchange(driver_, driver);
  const bool taken_back = before == Driver::kYieldingMachine && driver == Driver::kHand;
  if (driver == before || taken_back) return false;
  const bool dropped = !setPoint().isZero();
  stop();
  return dropped;
}

void DriveModel::step(Motion motion) {
  const RobotLimits& limits = parameters_.robot.limits;
  if (motion == Motion::kGo || motion == Motion::kBack) {
    const int change = motion == Motion::kGo ? 1 : -1;
    linear_steps_ = moved(linear_steps_, change, parameters_.linear_step, limits.max_linear);
  } else {
    const int change = motion == Motion::kLeft ? 1 : -1;
    angular_steps_ = moved(angular_steps_, change, parameters_.angular_step, limits.max_angular);
  }
}

Twist2 DriveModel::setPoint() const {
  if (!hold_) {
    return clamp({linear_steps_ * parameters_.linear_step, angular_steps_ * parameters_.angular_step},
                 parameters_.robot.limits);
  }
  const auto held = [this](Motion motion) { return held_[static_cast<std::size_t>(motion)] > 0 ? 1.0 : 0.0; };
  const double forward = held(Motion::kGo) - held(Motion::kBack);
  const double leftward = held(Motion::kLeft) - held(Motion::kRight);
  return clamp({forward * parameters_.hold_linear, leftward * parameters_.hold_angular}, parameters_.robot.limits);
}

}  // namespace frontier_pilot::teleop
