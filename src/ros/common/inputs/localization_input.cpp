#include "ros/common/inputs/localization_input.h"

#include <std_msgs/Bool.h>

#include "ros/common/names.h"

namespace frontier_pilot {

void LocalizationInput::subscribe(NodeConnections& connections) {
  connections_ = &connections;
  subscriber_ = connections.subscribe<std_msgs::Bool>(
      names::kLocalized, 1, [this](const std_msgs::Bool& msg) { localized_ = msg.data != 0; });
  connections.master().watchPublishers(subscriber_.getTopic());
  connections.inputs().need([this](const InputWatch::Topics&) {
    return isLocalized() ? std::string()
                         : "the mapper has not found the robot on its map: give a pose, or call " +
                               connections_->resolve(names::kLocalize);
  });
}

bool LocalizationInput::isLocalized() const {
  return localized_ || subscriber_.getNumPublishers() == 0 ||
         !connections_->master().mayBePublished(subscriber_.getTopic());
}

}  // namespace frontier_pilot
