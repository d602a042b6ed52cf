#include <algorithm>

#include "robot_check/checks.h"
#include "robot_check/other_names.h"

namespace frontier_pilot::robot_check {
namespace {

constexpr const char* kTwist = "geometry_msgs/Twist";
constexpr const char* kArbiterStatus = "frontier_pilot/ArbiterStatus";
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

/// The nodes that work with an arbiter, this robot's or another one's: itself, its sources, and those that read its
/// status, as the operator's window does, which also shows cmd_vel. None of them is a base.
std::vector<std::string> nodesOfArbiters(const Observation& seen, const Expectation& expected) {
  std::vector<std::string> own;
  const auto add = [&own](const std::vector<std::string>& nodes) { own.insert(own.end(), nodes.begin(), nodes.end()); };
  for (const Topic& topic : seen.topics) {
    if (topic.type != kArbiterStatus && topic.name != expected.arbiter_status) continue;
    add(topic.publishers);
    add(topic.subscribers);
  }
  for (const std::string& source : expected.sources) add(publishersOf(seen, source));
  return own;
}

/// A topic of velocities other than cmd_vel that a base obeys: somebody other than our own nodes listens to it, and
/// nobody publishes it. nullptr if there is none.
const Topic* findOtherBase(const Observation& seen, const Expectation& expected, const std::vector<std::string>& own) {
  for (const Topic& topic : seen.topics) {
    const auto& sources = expected.sources;
    const bool ours = std::find(sources.begin(), sources.end(), topic.name) != sources.end();
    if (topic.type == kTwist && topic.name != expected.cmd_vel && !ours && topic.publishers.empty() &&
        !without(topic.subscribers, own).empty()) {
      return &topic;
    }
  }
  return nullptr;
}

void checkBase(const Observation& seen, const Expectation& expected, Findings& findings) {
  const Topic* topic = findTopic(seen.topics, expected.cmd_vel);
  const std::vector<std::string> own = nodesOfArbiters(seen, expected);
  const std::vector<std::string> bases =
      topic == nullptr ? std::vector<std::string>() : without(topic->subscribers, own);
  if (!bases.empty()) return good(findings, expected.cmd_vel + " is obeyed by " + joined(bases));
  const Topic* other = findOtherBase(seen, expected, own);
  const std::string text = "no base listens to " + expected.cmd_vel;
  if (other == nullptr) return problem(findings, text, "start the base's driver");
  problem(findings, text + "; " + joined(without(other->subscribers, own)) + " listens to " + other->name,
          "set cmd_vel:=" + other->name);
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
            "end it, or have it publish " + expected.manual + ": the base obeys every message that it gets");
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
