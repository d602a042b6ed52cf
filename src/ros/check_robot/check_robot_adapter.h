#pragma once

#include <ros/node_handle.h>

#include "robot_check/findings.h"
#include "ros/check_robot/robot_observer.h"
#include "ros/common/names.h"
#include "ros/common/node_main.h"

namespace frontier_pilot {

struct CheckRobotParameters {
  double duration = 5.0;  ///< of the observation [s]
  std::string map_frame = names::kMapFrame;
  RobotModel robot;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("duration", duration, "s", "how long it listens to the robot", between(1.0, 8.0));
    v.field("map_frame", map_frame, "", "frame of the map", FrameName::kGiven);
    describeRobot(v, robot);
  }
};

/// The node `check_robot`: listens to the robot for some seconds, and says what is there, what is missing and what to
/// set. It publishes nothing. [ROB-3]
class CheckRobotAdapter {
 public:
  CheckRobotAdapter(ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// Listens, prints the findings, and returns the exit code: 0 if the robot could drive, 1 if not, 3 if the master no
  /// longer answers.
  int run(const RunningFn& running);

 private:
  bool askTheMaster(robot_check::Observation& seen) const;
  robot_check::Expectation expectation() const;

  CheckRobotParameters parameters_;
  RobotObserver observer_;
};

/// The whole program. Also 2 for wrong arguments or parameters, and 3 if there is no master.
int runCheckRobot(int argc, char** argv);

}  // namespace frontier_pilot
