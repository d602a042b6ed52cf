#pragma once

#include <string>

namespace frontier_pilot {

/// Lines of several nodes share the terminal of roslaunch: from now on each line of this process names its node, and
/// comes at once, also into a pipe or a file, where INFO would otherwise come long after the WARN that follows it. A
/// format that the user has set (ROSCONSOLE_FORMAT) stays. To be called before the first line; `node` is the name until
/// ROS knows the whole one.
void nameNodeInLines(const std::string& node);

/// From now on this process drops what the terminal or pipe behind `descriptor` does not take at once, instead of
/// waiting. Other processes that write to the same terminal or pipe wait as before. Files and sockets stay as they are:
/// returns whether anything was changed.
bool dropUnreadOutput(int descriptor);

/// The same for stdout and stderr. A terminal that is stopped (Ctrl-S), a pager, or a remote session whose network is
/// gone does not read, and a node that waited for it in a line of its log would hang with all its callbacks: an arbiter
/// could not be stopped. The log files and /rosout have every line. [FLT-1] [ARB-7]
void dropUnreadOutput();

}  // namespace frontier_pilot
