#pragma once

#include <map>
#include <string>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Which node speaks for which robot of a fleet. Messages under the name of a robot count from one node only: of two,
/// from the one in the namespace of that name, and otherwise from the one that was heard first. A recording that is
/// played back beside the robots, or a second robot with the same name, would otherwise have everyone believe that the
/// robot is in two places. [FLT-1]
class RobotSpeakers {
 public:
  /// The node that speaks for `robot` instead of `node`; empty if `node` may. A node that was silent for ten seconds
  /// speaks for nobody any more.
  std::string insteadOf(const std::string& node, const std::string& robot, SteadyTime now) const;
  /// `node` has said something for `robot` that was taken. Of more than a hundred robots the new ones are not
  /// remembered.
  void heard(const std::string& node, const std::string& robot, SteadyTime now);

 private:
  struct Speaker {
    std::string node;
    SteadyTime at;
  };
  std::map<std::string, Speaker> speakers_;  ///< by the robot's name
};

}  // namespace frontier_pilot
