#pragma once

#include <string>

#include "teleop/fleet_link.h"

/// The desktop window, for a main() that does not use Qt.
namespace frontier_pilot::gui {

/// Opens the window, in the colours of `palette` (see TeleopParameters), and runs it until it is closed or a robot's
/// link is no longer running. Returns the exit code. To be called in the main thread, once in a process.
int runPilotWindow(int argc, char** argv, teleop::FleetLink& link, const std::string& palette);

}  // namespace frontier_pilot::gui
