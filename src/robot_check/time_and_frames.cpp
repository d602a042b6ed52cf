#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "robot_check/checks.h"
#include "robot_check/frame_tree.h"
#include "robot_check/other_names.h"

namespace frontier_pilot::robot_check {
namespace {

constexpr double kTransformLag = 0.1;  // [s] that a transform may be behind

std::string arrow(const FrameLink& link) { return link.parent + " -> " + link.child; }

/// Transforms that the nodes drop, always or now and then.
void checkRefused(const std::vector<FrameLink>& links, Findings& findings) {
  for (const FrameLink& link : links) {
    if (link.stream.problem.empty()) continue;
    problem(findings,
            "the transform " + arrow(link) + " of " + joined(link.stream.publishers) +
                " cannot be used: " + link.stream.problem,
            "all nodes drop it: look into the node that publishes it");
  }
}

/// A frame has one parent, and one node that says where it is in it.
void checkOneParent(const Observation& seen, Findings& findings) {
  std::map<std::string, std::vector<const FrameLink*>> by_child;
  for (const FrameLink& link : seen.links) by_child[link.child].push_back(&link);
  for (const auto& [child, links] : by_child) {
    std::vector<std::string> named;
    for (const FrameLink* link : links) named.push_back(link->parent + " (" + joined(link->stream.publishers) + ")");
    if (links.size() > 1) {
      problem(findings, "frame " + child + " has several parents: " + joined(named),
              "end one of these nodes, or have it publish no transform: TF jumps between the two");
    } else if (links.front()->stream.publishers.size() > 1) {
      problem(findings,
              "several nodes publish the transform " + arrow(*links.front()) + ": " +
                  joined(links.front()->stream.publishers),
              "end one of them, or have it publish no transform (publish_tf: false or the like)");
    }
  }
}

void checkOdometryTransform(const Observation& seen, const Expectation& expected, Findings& findings) {
  const std::string& odom = expected.robot.odom_frame;
  const std::string& base = expected.robot.base_frame;
  const std::set<std::string> frames = framesOf(seen.links);
  if (frames.count(odom) == 0) {
    return problem(findings, sayMissingFrame(odom, frames, "odom_frame"),
                   "the base's driver or robot_localization has to publish the transform " + odom + " -> " + base);
  }
  if (!transformBetween(seen.links, odom, base)) {
    return problem(findings, "there is no transform from " + odom + " to " + base,
                   "the base's driver or robot_localization has to publish it");
  }
  const std::vector<const FrameLink*> way = wayUp(seen.links, base);
  if (std::none_of(way.begin(), way.end(), [&](const FrameLink* link) { return link->parent == odom; })) {
    return problem(findings, odom + " is not above " + base + " in the tree of frames",
                   "odom_frame has to be the frame in which odometry moves base_frame, or a frame above it");
  }
  for (const FrameLink* link : way) {
    if (!link->is_static) checkLag(seen, link->stream, "the transform " + arrow(*link), kTransformLag, findings);
    if (link->parent == odom) break;
  }
  good(findings, "TF: " + odom + " -> " + base + " is there");
}

}  // namespace

void checkTime(const Observation& seen, Findings& findings) {
  const Topic* clock = findTopic(seen.topics, "/clock");
  const bool published = clock != nullptr && !clock->publishers.empty();
  if (seen.use_sim_time && !published) {
    problem(findings, "use_sim_time is true, but nobody publishes /clock: every node waits for ever",
            "on a real robot: rosparam set use_sim_time false, and start all nodes again");
  } else if (seen.use_sim_time && !seen.clock_moves) {
    problem(findings, "use_sim_time is true, but /clock stands still", "is the simulation or the rosbag paused?");
  } else if (!seen.use_sim_time && published) {
    problem(
        findings,
        joined(clock->publishers) + " publishes /clock, but use_sim_time is not true: its stamps are of another time",
        "rosparam set use_sim_time true before the nodes start, or end that node");
  } else {
    good(findings, seen.use_sim_time ? "time: simulated, /clock runs (start navigation.launch, not real_robot.launch, "
                                       "which sets the computer's clock)"
                                     : "time: this computer's clock");
  }
}

void checkFrames(const Observation& seen, const Expectation& expected, Findings& findings) {
  checkRefused(seen.useless_links, findings);
  checkRefused(seen.links, findings);
  const std::set<std::string> frames = framesOf(seen.links);
  if (frames.empty()) {
    problem(findings,
            "nobody publishes a transform" + std::string(seen.useless_links.empty() ? "" : " that can be used"),
            "start the base's driver and robot_state_publisher; TF is shared, its topics are /tf and /tf_static");
  } else if (frames.count(expected.robot.base_frame) == 0) {
    problem(findings, sayMissingFrame(expected.robot.base_frame, frames, "base_frame"),
            "frames that are there: " + joined({frames.begin(), frames.end()}));
  } else {
    checkOdometryTransform(seen, expected, findings);
  }
  checkOneParent(seen, findings);
}

}  // namespace frontier_pilot::robot_check
