#pragma once

#include <actionlib/client/terminal_state.h>

#include <cstdint>

#include "waypoints/waypoint_follower.h"

namespace frontier_pilot {

/// What the end of a goal of move_base means. The navigator says in its text alone why it gave one up.
waypoints::LegEnd::Kind kindOf(const actionlib::TerminalState& state);
/// The error code of the action's result.
std::uint16_t codeOf(waypoints::WaypointOutcome outcome);

}  // namespace frontier_pilot
