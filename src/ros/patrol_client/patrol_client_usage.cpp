#include "ros/common/help/usages.h"

#include <frontier_pilot/PatrolAction.h>

#include "ros/common/names.h"

namespace frontier_pilot {

NodeUsage patrolClientUsage() {
  NodeUsage usage;
  usage.name = "patrol_client";
  usage.purpose =
      "Asks the patrol server to drive a shape, left turns only, and waits for the end. The robot comes back to\n"
      "where it stood. A line is printed when each leg starts. Ctrl-C stops the robot, waits until it is stopped\n"
      "and ends; a second Ctrl-C does not wait.";
  usage.arguments = "SHAPE [--side METRES | --radius METRES] [--laps N]";
  usage.options =
      "  SHAPE              square, triangle or circle\n"
      "  --side METRES      length of a side (default 1.0)\n"
      "  --radius METRES    the same for a circle (default 1.0)\n"
      "  --laps N           how often (default 1)\n"
      "  -h, --help         this text\n";
  usage.calls = {port<PatrolAction>(names::kPatrol)};
  usage.exit_codes =
      "  0    patrol complete\n"
      "  1    aborted, refused or replaced by another patrol: the reason is printed\n"
      "  2    wrong arguments\n"
      "  3    no patrol server, no ROS time, or the server died\n"
      "  130  stopped by Ctrl-C\n"
      "  143  stopped by SIGTERM\n";
  usage.example = "rosrun frontier_pilot patrol_client square --side 1.0 --laps 2";
  return usage;
}

}  // namespace frontier_pilot
