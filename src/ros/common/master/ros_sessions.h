#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace frontier_pilot {

/// When `process`, of this computer, was started, in clock ticks since boot; 0 if it no longer exists.
std::uint64_t beginOf(int process);

/// The id of this computer's present run.
std::string bootId();

/// The names that identify this ROS session: the run id that roslaunch sets, a parameter that can be deleted, and the
/// process id of the master with the machine's boot id and, if the master runs on this computer, when it was started.
std::vector<std::string> rosSessions();

}  // namespace frontier_pilot
