#include "ros/common/inputs/localization_input.h"

#include <std_msgs/Bool.h>

#include "ros/common/clock.h"
#include "ros/common/names.h"

namespace frontier_pilot {

void LocalizationInput::subscribe(NodeConnections& connections, Need need) {
  connections_ = &connections;
  subscriber_ = connections.subscribe<std_msgs::Bool>(names::kLocalized, 1,
                                                      [this](const std_msgs::Bool& msg) { take(msg.data != 0); });
  connections.master().watchPublishers(subscriber_.getTopic());
  if (need == Need::kOptional) return;
  connections.inputs().need([this](const InputWatch::Topics&) {
    return isLocalized() ? std::string()
                         : "the mapper has not found the robot on its map: give a pose, or call " +
                               connections_->resolve(names::kLocalize);
  });
}

void LocalizationInput::take(bool localized) {
  if (localized && !localized_) found_at_ = rosNow();
  localized_ = localized;
}

bool LocalizationInput::isLocalizedAt(const std::optional<StampedPose2>& pose) const {
  const bool counts = found_at_ && *found_at_ <= rosNow();  // not after the clock was set back
  return isLocalized() && !(counts && pose && pose->stamp <= *found_at_);
}

bool LocalizationInput::isLocalized() const { return localized_ || !connections_->master().mayReceive(subscriber_); }

}  // namespace frontier_pilot
