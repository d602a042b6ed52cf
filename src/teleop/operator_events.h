#pragma once

#include <vector>

#include "teleop/operator_link.h"

namespace frontier_pilot::teleop {

/// What an operator wants to read of having happened between two states: stops, changes of hands, the explorer's steps,
/// a patrol's legs, and what went wrong. What is asked for and how that was answered is in the log anyway.
std::vector<OperatorLogLine> eventsBetween(const OperatorState& before, const OperatorState& now);

}  // namespace frontier_pilot::teleop
