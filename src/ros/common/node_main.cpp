#include "ros/common/node_main.h"

#include <ros/callback_queue.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/ros.h>
#include <ros/service_manager.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "ros/common/callback_guard.h"
#include "ros/common/launch_wait.h"
#include "ros/common/logging/console_output.h"
#include "ros/common/master/namesake.h"
#include "ros/common/master/own_parameters.h"
#include "ros/common/master/slave_api.h"
#include "ros/common/master/xml_rpc.h"
#include "ros/common/parameters.h"
#include "ros/common/publish_flush.h"

namespace frontier_pilot {

namespace {

// A signal is handled on any thread, among them the one that watches the master and raises it.
std::atomic<int> g_stop{0};  ///< the signal that ends the node
std::atomic<bool> g_building{true};
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free,
              "a handler of signals must not wait for a lock");

constexpr unsigned kBuildPatience = 1;  // [s]
constexpr unsigned kEndPatience =
    6;  // [s] for the node to be taken down: roscpp waits for ever for a master that hangs

void onSignal(int signal) {
  // A constructor may wait for something that never comes, or take long to read a large world. A shutdown of ROS ends
  // such a wait and unregisters what is registered so far. If the constructor goes on all the same, the alarm or the
  // next signal ends the process at once: a node under construction has not commanded anything yet.
  if ((g_building && g_stop != 0) || signal == SIGALRM) _exit(128 + (g_stop != 0 ? g_stop.load() : signal));
  g_stop = signal;
  if (!g_building) return;
  alarm(kBuildPatience);
  ros::requestShutdown();
}

/// A shutdown of ROS while its connections are being made sometimes runs into an assertion or a trap inside of roscpp.
/// The node was to end anyway.
void onCrash(int signal) {
  if (g_stop != 0) _exit(128 + g_stop);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Replaces ROS' own handler, which closes the publishers before the node can publish its last messages. A terminal
/// that is closed ends a node like Ctrl-C, unless it was started with nohup. A log file that has reached a limit of the
/// system (ulimit -f) ends no node.
void catchSignals() {
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
  std::signal(SIGALRM, onSignal);
  if (std::signal(SIGHUP, onSignal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGABRT, onCrash);
  std::signal(SIGTRAP, onCrash);
}

/// Whether the node is to go on. To be called repeatedly, and only once the node is built.
bool isRunning() {
  g_building = false;
  return ros::ok() && g_stop == 0;
}

/// The node's own callbacks are guarded already; this guard is for those of libraries.
void spinUntilStopped() {
  CallbackGuard guard;
  while (isRunning()) {
    guard.run("a callback", [] { ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.1)); });
  }
}

void end(const RunningNode& running) {
  if (!running.say_last_words) return;
  CallbackGuard guard;
  guard.run("the last words", running.say_last_words);
  flushLastWords();
}

/// Only roslaunch names a node's log file.
bool isWordOfRoslaunch(const char* word) { return std::strncmp(word, "__log:=", 7) == 0; }

/// roscpp waits for a master for ever, and says no more than that a call has failed.
void sayIfThereIsNoMaster() {
  if (ros::master::check()) return;
  ROS_WARN_STREAM("no ROS master answers at " << ros::master::getURI()
                                              << ": waiting for one, which roscore or roslaunch starts");
}

/// Whether `uri` has a port from 1 to 65535 at its end, or before a path. roscpp takes anything for one, and waits for
/// ever for a master at another port.
bool hasAPort(const std::string& uri) {
  const std::string port = uri.substr(uri.rfind(':') + 1);
  const std::string digits = port.substr(0, port.find('/'));
  if (digits.empty() || digits.size() > 5 || digits.find_first_not_of("0123456789") != std::string::npos) return false;
  return std::stoi(digits) >= 1 && std::stoi(digits) <= 65535;
}

/// roscpp aborts if the address of the master cannot be one.
void refuseAWrongAddress(const std::vector<std::string>& words) {
  const std::string option = "__master:=";
  const char* variable = std::getenv("ROS_MASTER_URI");
  std::string said = "ROS_MASTER_URI", uri = variable != nullptr ? variable : "http://localhost:11311";
  for (const std::string& word : words) {
    if (word.compare(0, option.size(), option) == 0) said = option, uri = word.substr(option.size());
  }
  std::string host;
  std::uint32_t port = 0;
  if (ros::network::splitURI(uri, host, port) && !host.empty() && hasAPort(uri)) return;
  throw ConfigurationError(said + " is not an address like http://host:11311: " + uri);
}

/// roscpp makes a topic without a name of it and aborts. What begins with `_` is a parameter or a word for roscpp
/// itself.
void refuseAnEmptyRemapping(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::size_t separator = word.find(":=");
    if (separator == std::string::npos || word[0] == '_') continue;
    if (word.find_first_not_of('/', separator + 2) == std::string::npos)
      throw ConfigurationError(word + " is not a remapping: it says no name of a topic or a service");
  }
}

/// With fewer, roscpp ends the process with a trap, or it cannot connect to the other nodes.
void refuseAFewDescriptors() {
  constexpr rlim_t kLeast = 32;
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= kLeast) return;
  throw std::runtime_error("this process may open " + std::to_string(limit.rlim_cur) +
                           " files and connections, and a node needs " + std::to_string(kLeast) +
                           " at the very least: raise the limit (ulimit -n)");
}

int fail(const std::string& name, const std::exception& error, int exit_code) {
  ROS_FATAL_STREAM(name << ": " << error.what());
  // Also on stderr, because the console may be configured to hide or buffer it.
  std::cerr << name << ": " << error.what() << std::endl;
  return exit_code;
}

}  // namespace

void initNode(int& argc, char** argv, const std::string& name) {
  nameNodeInLines(name);
  refuseAFewDescriptors();
  const std::vector<std::string> words(argv + 1, argv + argc);
  refuseAWrongAddress(words);
  refuseAnEmptyRemapping(words);
  try {
    ros::init(argc, argv, name, ros::init_options::NoSigintHandler);
  } catch (const ros::Exception& error) {  // a word, or ROS_NAMESPACE, is no name, or a port is no number
    throw ConfigurationError(error.what());
  }
}

void initProgram(int& argc, char** argv, const std::string& name) {
  ros::master::setRetryTimeout(ros::WallDuration(2.0));
  initNode(argc, argv, name);
  ros::master::setRetryTimeout(ros::WallDuration(0.0));  // waits again
}

void limitTheEnd() {
  if (!pidOfMaster()) limitTheEndAnyway();
}

void limitTheEndAnyway() { alarm(kEndPatience); }

int runNode(int argc, char** argv, const NodeUsage& usage,
            const std::function<RunningNode(ros::NodeHandle&, ros::NodeHandle&)>& make,
            const std::function<void()>& check) {
  return runNodeWithLoop(
      argc, argv, usage,
      [&make](ros::NodeHandle& node, ros::NodeHandle& private_node, const RunningFn&) {
        dropUnreadOutput();
        const RunningNode running = make(node, private_node);
        spinUntilStopped();
        end(running);
        limitTheEnd();
        return 0;
      },
      check);
}

int runNodeWithLoop(int& argc, char** argv, const NodeUsage& usage,
                    const std::function<int(ros::NodeHandle&, ros::NodeHandle&, const RunningFn&)>& body,
                    const std::function<void()>& check) {
  if (const auto answered = answerCommandLine({argv + 1, argv + argc}, usage)) return *answered;
  const bool is_of_roslaunch = std::any_of(argv + 1, argv + argc, isWordOfRoslaunch);  // before ROS takes its words out
  const auto cannot_start = [&](const std::exception& error, int exit_code) {
    fail(usage.name, error, exit_code);
    if (is_of_roslaunch) waitForTheLaunch();
    return exit_code;
  };
  try {
    initNode(argc, argv, usage.name);
    catchSignals();
    if (check) check();
    sayIfThereIsNoMaster();
    refuseANamesake();
    followThePredecessor(is_of_roslaunch);
    ros::NodeHandle node;
    ros::NodeHandle private_node("~");
    // roscpp's `get_loggers` crashes inside of the log library when it is called a second time. [FLT-1]
    ros::ServiceManager::instance()->unadvertiseService(private_node.resolveName("get_loggers"));
    replaceHarmfulMethods();
    const int exit_code = body(node, private_node, isRunning);
    flushLastWords();  // for the last lines on /rosout
    return exit_code;
  } catch (const ConfigurationError& error) {
    return cannot_start(error, 2);
  } catch (const std::exception& error) {
    return cannot_start(error, 1);
  }
}

}  // namespace frontier_pilot
