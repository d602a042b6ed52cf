#include <algorithm>

#include "robot_check/checks.h"
#include "robot_check/other_names.h"

namespace frontier_pilot::robot_check {
namespace {

constexpr const char* kTwist = "geometry_msgs/Twist";
constexpr double kLongWatchdog = 2.0;  // [s]

std::vector<std::string> without(const std::vector<std::string>& nodes, const std::vector<std::string>& left_out) {
  std::vector<std::string> rest;
  for (const std::string& node : nodes) {
    if (std::find(left_out.begin(), left_out.end(), node) == left_out.end()) rest.push_back(node);
  }
  return rest;
}

std::vector<std::string> publishersOf(const Observation& seen, const std::string& name) {
  const Topic* topic = findTopic(seen.topics, name);
  return topic == nullptr ? std::vector<std::string>() : topic->publishers;
}

/// Topics that only bases listen to: nobody publishes them, and they are none of our own sources.
std::string findOtherBase(const Observation& seen, const Expectation& expected) {
  for (const Topic& topic : seen.topics) {
    const bool own = topic.name.rfind(expected.cmd_vel + "_", 0) == 0;
    if (topic.type == kTwist && topic.name != expected.cmd_vel && !own && topic.publishers.empty() &&
        !topic.subscribers.empty()) {
      return topic.name;
    }
  }
  return {};
}

void checkBase(const Observation& seen, const Expectation& expected, Findings& findings) {
  const Topic* topic = findTopic(seen.topics, expected.cmd_vel);
  std::vector<std::string> bases = topic == nullptr ? std::vector<std::string>() : topic->subscribers;
  bases = without(bases, publishersOf(seen, expected.cmd_vel + "_manual"));  // the operator's window only shows it
  if (!bases.empty()) return good(findings, expected.cmd_vel + " is obeyed by " + joined(bases));
  const std::string other = findOtherBase(seen, expected);
  const std::string text = "nobody listens to " + expected.cmd_vel;
  if (other.empty()) return problem(findings, text, "start the base's driver");
  problem(findings, text + "; " + joined(findTopic(seen.topics, other)->subscribers) + " listens to " + other,
          "set cmd_vel:=" + other);
}

}  // namespace

void checkDrive(const Observation& seen, const Expectation& expected, Findings& findings) {
  checkBase(seen, expected, findings);
  const std::vector<std::string> arbiters = publishersOf(seen, expected.arbiter_status);
  if (arbiters.size() > 1) {
    problem(findings, "there are several arbiters: " + joined(arbiters),
            "end all but one: an emergency stop reaches only one of them");
  }
  const std::vector<std::string> rivals = without(publishersOf(seen, expected.cmd_vel), arbiters);
  if (!rivals.empty()) {
    problem(findings, joined(rivals) + " publishes " + expected.cmd_vel + " past the arbiter",
            "end it, or have it publish " + expected.cmd_vel + "_manual: the base obeys every message that it gets");
  }
  const double watchdog = expected.robot.watchdog;
  if (watchdog > kLongWatchdog) {
    return problem(findings,
                   "by the robot's file the base goes on for " + number(watchdog) + " s after the last command",
                   "set a shorter watchdog in the base's driver, and in the robot's file");
  }
  note(findings,
       "the base's watchdog is not tested, because that would move it: by the robot's file it stops after " +
           number(watchdog) + " s without a command",
       "try it once: drive slowly, end the node that drives, and see that the base stops");
}

void checkMappers(const Observation& seen, const Expectation& expected, Findings& findings) {
  std::vector<std::string> own;
  if (const auto mapper = seen.providers.find(expected.save_map); mapper != seen.providers.end())
    own.push_back(mapper->second);
  const std::vector<std::string> maps = publishersOf(seen, expected.map);
  if (maps.size() > 1) {
    problem(findings, "several nodes publish " + expected.map + ": " + joined(maps),
            "end all but one: each one's map is in a frame of its own");
  }
  for (const FrameLink& link : seen.links) {
    const bool places_odometry = link.parent == expected.map_frame && link.child == expected.robot.odom_frame;
    const std::vector<std::string> others = without(link.stream.publishers, own);
    if (!places_odometry || others.empty()) continue;
    problem(findings,
            joined(others) + " publishes the transform " + link.parent + " -> " + link.child + ", as our mapper does",
            "end that mapper or localisation (gmapping, amcl, cartographer), or start without our mapper");
  }
}

}  // namespace frontier_pilot::robot_check
