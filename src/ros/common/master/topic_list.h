#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robot_check/observation.h"
#include "ros/common/master/master_state.h"

namespace frontier_pilot {

/// The type of each topic that the master knows; nothing if it does not answer within two seconds.
std::optional<std::map<std::string, std::string>> askTopicTypes();

/// All topics of `state` with their types, without this node among their publishers and subscribers.
std::vector<robot_check::Topic> listTopics(const MasterState& state, const std::map<std::string, std::string>& types);

}  // namespace frontier_pilot
