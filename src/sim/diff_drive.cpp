#include "sim/diff_drive.h"

namespace frontier_pilot::sim {

void DiffDrive::command(const Twist2& twist, Time now) { command_ = Command{clamp(twist, limits_), now}; }

const Twist2& DiffDrive::update(Time now, double seconds) {
  if (command_ && now - command_->stamp > watchdog_) command_.reset();
  velocity_ = limitAcceleration(command_ ? command_->twist : Twist2{}, velocity_, limits_, seconds);
  return velocity_;
}

void DiffDrive::stop() {
  command_.reset();
  velocity_ = {};
}

}  // namespace frontier_pilot::sim
