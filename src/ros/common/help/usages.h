#pragma once

#include "ros/common/help/node_usage.h"

namespace frontier_pilot {

// What each node says of itself; defined in the folder of the node, in <node>_usage.cpp.
NodeUsage simulatorUsage();
NodeUsage cmdVelArbiterUsage();
NodeUsage obstacleAvoiderUsage();
NodeUsage patrolServerUsage();
NodeUsage patrolClientUsage();
NodeUsage behaviorServerUsage();
NodeUsage mapperUsage();
NodeUsage mapMergerUsage();
NodeUsage fleetStopUsage();
NodeUsage navigatorUsage();
NodeUsage waypointFollowerUsage();
NodeUsage frontierExplorerUsage();
NodeUsage teleopGuiUsage();
NodeUsage checkRobotUsage();

}  // namespace frontier_pilot
