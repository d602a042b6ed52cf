#pragma once

#include <vector>

#include "teleop/operator_link.h"

namespace frontier_pilot::teleop {

/// What happened between two states, for the operator's log: emergency stops, changes of the active source, the
/// explorer's transitions, a patrol's legs, and problems. Requests and their answers are logged elsewhere.
std::vector<OperatorLogLine> eventsBetween(const OperatorState& before, const OperatorState& now);

}  // namespace frontier_pilot::teleop
