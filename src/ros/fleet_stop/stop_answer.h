#pragma once

#include <string>
#include <vector>

namespace frontier_pilot {

/// What has become of the call to one robot.
enum class StopOutcome {
  kConfirmed,
  kSilent,     ///< it has been called, and has not answered in time
  kNoService,  ///< its service is not registered, or nobody listens there
  kRefused,    ///< it has answered that it does not stop, or the call broke off
};

struct StopAnswer {
  StopOutcome outcome = StopOutcome::kSilent;
  std::string text;  ///< what the robot has said
};

/// The answer of one robot, by the name of its service.
struct RobotAnswer {
  std::string service;
  StopAnswer answer;
};

/// The answer of fleet/emergency_stop: a success only if there is a robot and all have confirmed.
struct FleetAnswer {
  bool success = false;
  std::string message;  ///< names the robots that have not confirmed, and why, or that have done so with a reserve
};
FleetAnswer summarize(const std::vector<RobotAnswer>& answers);

/// The robot's name, of its resolved service `/robot1/emergency_stop`; "/" for a robot without a namespace.
std::string robotOf(const std::string& service);
/// The service of the arbiter that publishes the status `topic`; empty if it is another topic.
std::string serviceBeside(const std::string& topic);

}  // namespace frontier_pilot
