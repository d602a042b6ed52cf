#pragma once

#include <string>
#include <vector>

namespace frontier_pilot {

/// The names that identify this ROS session: the run id that roslaunch sets, a parameter that can be deleted, and the
/// process id of the master with the machine's boot id and, if the master runs on this computer, when it was started.
/// None of those that the master does not tell within two seconds: it may have died.
std::vector<std::string> rosSessions();

}  // namespace frontier_pilot
