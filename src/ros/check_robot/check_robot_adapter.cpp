#include "ros/check_robot/check_robot_adapter.h"

#include <ros/callback_queue.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/names.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "ros/common/clock.h"
#include "ros/common/help/usages.h"
#include "ros/common/master/topic_list.h"
#include "ros/common/parameters.h"

namespace frontier_pilot {
namespace {

constexpr int kNotReady = 1, kWrongWords = 2, kNoMaster = 3;
constexpr double kLook = 0.05;  // [s] between two looks at the end
int fail(const std::string& text, int exit_code) {
  std::cerr << "check_robot: " << text << std::endl;
  return exit_code;
}

/// Takes nodes that were killed, which the master still lists, off the topics.
void dropDead(std::vector<robot_check::Topic>& topics) {
  std::map<std::string, bool> lives;
  const auto isDead = [&lives](const std::string& node) {
    const auto [entry, unknown] = lives.try_emplace(node);
    if (unknown) entry->second = nodeLives(node);
    return !entry->second;
  };
  for (robot_check::Topic& topic : topics) {
    for (std::vector<std::string>* nodes : {&topic.publishers, &topic.subscribers})
      nodes->erase(std::remove_if(nodes->begin(), nodes->end(), isDead), nodes->end());
  }
}

}  // namespace

CheckRobotAdapter::CheckRobotAdapter(ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : parameters_(loadNodeParameters<CheckRobotParameters>(private_node)), observer_(node) {}

robot_check::Expectation CheckRobotAdapter::expectation() const {
  robot_check::Expectation expected;
  expected.scan = ros::names::resolve(names::kScan);
  expected.odom = ros::names::resolve(names::kOdom);
  expected.cmd_vel = ros::names::resolve(names::kCmdVel);
  expected.sources.clear();
  for (const char* source :
       {names::kCmdVelAvoid, names::kCmdVelBehavior, names::kCmdVelPatrol, names::kCmdVelNav, names::kCmdVelManual}) {
    expected.sources.push_back(ros::names::resolve(source));
  }
  expected.manual = ros::names::resolve(names::kCmdVelManual);
  expected.arbiter_status = ros::names::resolve(names::kArbiterStatus);
  expected.map = ros::names::resolve(names::kMap);
  expected.save_map = ros::names::resolve(names::kSaveMap);
  expected.map_frame = parameters_.map_frame;
  expected.robot = parameters_.robot;
  return expected;
}

bool CheckRobotAdapter::askTheMaster(robot_check::Observation& seen) const {
  const auto state = askMaster();
  const auto types = askTopicTypes();
  if (!state || !types) return false;
  seen.topics = listTopics(*state, *types);
  dropDead(seen.topics);
  for (const auto& [service, nodes] : state->providers) {
    if (!nodes.empty()) seen.providers[service] = nodes.front();
  }
  return true;
}

int CheckRobotAdapter::run(const RunningFn& running) {
  std::cout << "listening to the robot for " << parameters_.duration << " s ..." << std::endl;
  const Time ros_begin = rosNow();
  const SteadyTime begin = steadyNow();
  while (running() && steadyNow() - begin < fromSeconds(parameters_.duration))
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kLook));
  if (!running()) return kNotReady;
  robot_check::Observation seen = observer_.observation();
  seen.seconds = toSeconds(steadyNow() - begin);
  seen.use_sim_time = ros::Time::isSimTime();
  seen.clock_moves = rosNow() > ros_begin;
  if (!askTheMaster(seen)) return fail("the ROS master at " + ros::master::getURI() + " no longer answers", kNoMaster);
  const robot_check::Findings findings = robot_check::judge(seen, expectation());
  if (!(std::cout << robot_check::toText(findings) << std::flush))
    return fail("the answer cannot be written", kNotReady);
  return robot_check::couldDrive(findings) ? 0 : kNotReady;
}

int runCheckRobot(int argc, char** argv) {
  const NodeUsage usage = checkRobotUsage();
  if (const auto answered = answerCommandLine({argv + 1, argv + argc}, usage)) return *answered;
  try {
    initProgram(argc, argv, usage.name);
  } catch (const std::exception& error) {
    return fail(error.what(), kWrongWords);
  }
  if (!askMaster()) {
    return fail("no ROS master answers at " + ros::master::getURI() +
                    ": start the robot's launch file or roscore, or set ROS_MASTER_URI",
                kNoMaster);
  }
  return runNodeWithLoop(argc, argv, usage,
                         [](ros::NodeHandle& node, ros::NodeHandle& private_node, const RunningFn& running) {
                           return CheckRobotAdapter(node, private_node).run(running);
                         });
}

}  // namespace frontier_pilot
