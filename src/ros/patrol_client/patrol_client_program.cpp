#include <ros/callback_queue.h>
#include <ros/init.h>
#include <ros/master.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "ros/common/clock.h"
#include "ros/common/help/usages.h"
#include "ros/common/logging/console_output.h"
#include "ros/common/master/namesake.h"
#include "ros/common/master/slave_api.h"
#include "ros/common/node_main.h"
#include "ros/patrol_client/patrol_client_adapter.h"

namespace frontier_pilot {
namespace {

constexpr Duration kTimePatience = std::chrono::milliseconds(3400);
constexpr double kTimeLook = 0.05;  // [s] between two looks
constexpr int kExitBySignal = 128;  // added to the signal, as by a shell

volatile std::sig_atomic_t interrupts = 0;
volatile std::sig_atomic_t last_signal = SIGINT;
volatile std::sig_atomic_t asks_the_master = 1;
void handleInterrupt(int signal) {
  // A master that does not answer would be waited for, and there is no patrol yet that would have to be cancelled.
  if (asks_the_master != 0) _exit(kExitBySignal + signal);
  interrupts = interrupts + 1;
  last_signal = signal;
}

int codeOf(patrol::PatrolExit exit) {
  return exit == patrol::PatrolExit::kInterrupted ? kExitBySignal + last_signal : static_cast<int>(exit);
}
int fail(const std::string& text, patrol::PatrolExit exit) {
  PatrolClientAdapter::complain(text);
  return codeOf(exit);
}

/// Waits for a valid ROS time: actionlib's client would do so in its constructor, deaf to signals, for ever. Returns
/// why there is nothing to wait for any more; std::nullopt as soon as there is a time.
std::optional<patrol::PatrolExit> awaitTime() {
  const SteadyTime begin = steadyNow();
  while (rosNow() == Time{}) {
    if (interrupts > 0) return patrol::PatrolExit::kInterrupted;
    if (!ros::ok()) return patrol::PatrolExit::kNoServer;
    if (steadyNow() - begin >= kTimePatience) {
      PatrolClientAdapter::complain("there is no ROS time: /use_sim_time is set, and nobody publishes /clock");
      return patrol::PatrolExit::kNoServer;
    }
    ros::WallDuration(kTimeLook).sleep();
  }
  return std::nullopt;
}

}  // namespace

int runPatrolClient(int argc, char** argv) {
  std::vector<std::string> words;
  ros::removeROSArgs(argc, argv, words);
  words.erase(words.begin());
  const patrol::PatrolCommandLine line = patrol::parsePatrolCommandLine(words);
  if (line.help) return printHelp(patrolClientUsage());
  if (!line.goal)
    return fail(line.problem + "; 'patrol_client --help' lists what it takes", patrol::PatrolExit::kUsage);
  try {
    initProgram(argc, argv, "patrol_client");
    std::signal(SIGINT, handleInterrupt);
    std::signal(SIGTERM, handleInterrupt);
    if (std::signal(SIGHUP, handleInterrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
    if (!ros::master::check()) return fail("no ROS master at " + ros::master::getURI(), patrol::PatrolExit::kNoServer);
    refuseANamesake();
    asks_the_master = 0;
  } catch (const std::runtime_error& error) {
    return fail(error.what(), patrol::PatrolExit::kUsage);
  }
  ros::NodeHandle node;
  replaceHarmfulMethods();  // `rosnode kill` cancels the patrol as a signal does
  dropUnreadOutput();
  if (const auto outcome = awaitTime()) return codeOf(*outcome);
  PatrolClientAdapter client(node, *line.goal);
  while (ros::ok()) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(kTimeLook));
    const auto outcome = client.update(interrupts);
    if (!outcome) continue;
    if (!client.awaitsCancel()) return codeOf(*outcome);
    // An end in order takes this node from the master, and a server that wakes then drops the connection, unread.
    std::cout.flush();
    std::_Exit(codeOf(*outcome));
  }
  return codeOf(patrol::PatrolExit::kNoServer);
}

}  // namespace frontier_pilot
