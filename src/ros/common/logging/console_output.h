#pragma once

namespace frontier_pilot {

/// From now on this process drops what the terminal or pipe behind `descriptor` does not take at once, instead of
/// waiting. Other processes that write to the same terminal or pipe wait as before. Files and sockets stay as they are:
/// returns whether anything was changed.
bool dropUnreadOutput(int descriptor);

/// The same for stdout and stderr. A terminal that is stopped (Ctrl-S), a pager, or a remote session whose network is
/// gone does not read, and a node that waited for it in a line of its log would hang with all its callbacks: an arbiter
/// could not be stopped. The log files and /rosout have every line. [FLT-1] [ARB-7]
void dropUnreadOutput();

}  // namespace frontier_pilot
