#pragma once

#include <functional>
#include <string>

namespace frontier_pilot {

/// Waits two seconds for `find()` to find no node any more: one that is being started again may still be saying its
/// last words. Gives the name of the one that is still there; empty if there is none.
std::string waitUntilGone(const std::function<std::string()>& find);

/// Throws std::runtime_error if a node of this one's name lives already. To be called before the node is started: ROS
/// ends the older of two nodes of one name, and a mapper that is ended takes its map with it. [FLT-2]
void refuseANamesake();

/// Throws std::runtime_error if another living node, whatever its name, offers `service` already: two nodes that drive
/// the same robot on their own could not be told apart by who switches one of them off. To be called before the node is
/// started: of two that are started at the same moment neither finds the other. [FLT-2]
void refuseASecondProvider(const char* service);

}  // namespace frontier_pilot
