#pragma once

#include <functional>
#include <string>

#include "teleop/fleet_link.h"

/// The desktop window, for a main() that does not use Qt.
namespace frontier_pilot::gui {

/// Opens the window, in the colours of `palette` (see TeleopParameters), and runs it until it is closed or a robot's
/// link is no longer running. Returns the exit code. To be called in the main thread, once in a process. Where no
/// window can be opened, as without a display, `say_why_not` is given the reason, and the process ends with exit
/// code 1. `closed` is called when the window has been closed and has sent its zero, before the robots' links are taken
/// down.
int runPilotWindow(int argc, char** argv, teleop::FleetLink& link, const std::string& palette,
                   const std::function<void(const std::string&)>& say_why_not, const std::function<void()>& closed);

}  // namespace frontier_pilot::gui
