#pragma once

#include <string>
#include <vector>

#include "robot_check/observation.h"

namespace frontier_pilot::robot_check {

enum class Mark {
  kGood,     ///< as it should be
  kNote,     ///< worth knowing; the robot can drive
  kProblem,  ///< the robot cannot drive, or not safely, until it is put right
};

/// One sentence about the robot, and what to do about it.
struct Finding {
  Mark mark;
  std::string text;
  std::string advice;  ///< empty if there is nothing to do
};

using Findings = std::vector<Finding>;

/// All that can be said of the robot, in the order in which it is to be put right.
Findings judge(const Observation& seen, const Expectation& expected);

/// Whether the robot could drive: no finding is a problem.
bool couldDrive(const Findings& findings);

/// One or two lines for each finding, and a last one with the verdict.
std::string toText(const Findings& findings);

}  // namespace frontier_pilot::robot_check
