#pragma once

#include <string>
#include <vector>

namespace frontier_pilot {

/// The names that identify this ROS session: the run id that roslaunch sets, a parameter that can be deleted, and, if
/// the master's process is seen here, its id, when it was started, and the boot id. A master on another computer or in
/// another container may have the same process id each time that it is started. None of those that the master does not
/// tell within two seconds: it may have died.
std::vector<std::string> rosSessions();
/// The name by the master's process id; empty if that is not the id of a master here.
std::string nameOfMaster(int process);

}  // namespace frontier_pilot
