#pragma once

#include <functional>
#include <string>

namespace frontier_pilot {

/// Waits up to two seconds until `find()` finds no node any more: the previous process of a node that is being
/// restarted may still be shutting down. Returns the name of the node that is still there; empty if there is none.
std::string waitUntilGone(const std::function<std::string()>& find);

/// Throws std::runtime_error if a node with this one's name is already running. To be called before the node is
/// started: of two nodes with the same name ROS shuts down the older one, and with a mapper its map would be lost, and
/// with an arbiter a stop. On this computer it is found even if the master does not know it, because it has outlived an
/// earlier one at the same address. [FLT-2]
void refuseANamesake();

/// Throws std::runtime_error if another living node, whatever its name, already offers `service`: two nodes would drive
/// or map for the same robot, and a call of the service would reach only the newer one. To be called before the node is
/// started. Two nodes that are started at the same moment do not find each other. [FLT-2] [MAP-3]
void refuseASecondProvider(const char* service);

/// The same for a node that serves `action`: each of two servers would pursue every goal. [FLT-2]
void refuseASecondServer(const char* action);

}  // namespace frontier_pilot
