#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "ros/common/help/node_usage.h"

namespace frontier_pilot {

/// A node, and a function that publishes its last messages before it ends, such as a zero or a cancel; may be empty.
struct RunningNode {
  std::shared_ptr<void> node;
  std::function<void()> say_last_words;
};

/// ros::init() without its handler of signals. Throws ConfigurationError if a word of the command line,
/// ROS_MASTER_URI or ROS_NAMESPACE is no name or address, and std::runtime_error if the process may open hardly any
/// file; roscpp would end the process with a trap.
void initNode(int& argc, char** argv, const std::string& name);
/// The same for a program that has to report a missing master: for each parameter that the command line sets
/// (`_NAME:=VALUE`) it waits for a master for two seconds, where roscpp would wait for ever.
void initProgram(int& argc, char** argv, const std::string& name);

/// Answers --help and wrong arguments, without a master; otherwise runs the node: `make(node, private_node)` builds it,
/// then callbacks run on this one thread until SIGINT, SIGTERM, SIGHUP or a ROS shutdown. After a signal
/// `say_last_words` is called, and its messages are sent before the node is destroyed, because a publisher that is
/// destroyed drops what it has not sent yet. An exception of a callback is logged, and the node goes on. An exception
/// of `make` is logged, also on stderr, and ends the node; so do, before the node registers at the master, an exception
/// of `check` and a living node of the same name. Returns the exit code: 0, or 1 after an exception, or 2 after a
/// ConfigurationError or a wrong argument.
int runNode(int argc, char** argv, const NodeUsage& usage,
            const std::function<RunningNode(ros::NodeHandle&, ros::NodeHandle&)>& make,
            const std::function<void()>& check = {});

template <class Node, class = void>
struct HasLastWords : std::false_type {};
template <class Node>
struct HasLastWords<Node, std::void_t<decltype(std::declval<Node&>().sayLastWords())>> : std::true_type {};

/// The same for a class with a constructor `Node(ros::NodeHandle& node, ros::NodeHandle& private_node)` and,
/// optionally, a function `sayLastWords()`.
template <class Node>
int runNode(int argc, char** argv, const NodeUsage& usage, const std::function<void()>& check = {}) {
  return runNode(
      argc, argv, usage,
      [](ros::NodeHandle& node, ros::NodeHandle& private_node) {
        const auto running = std::make_shared<Node>(node, private_node);
        RunningNode result{running, {}};
        if constexpr (HasLastWords<Node>::value) result.say_last_words = [&node = *running] { node.sayLastWords(); };
        return result;
      },
      check);
}

/// To be called before a node is taken down. roscpp waits for ever for a master that hangs, to unregister: the process
/// ends all the same some seconds later. One that is saving a map may take longer, as long as the master answers.
void limitTheEnd();
/// The same for a node that saves nothing: its process ends some seconds later whatever it waits for.
void limitTheEndAnyway();

/// The same for a node with a main loop of its own, such as a window: `body(node, private_node, running)` runs the
/// node, has to return soon after `running()` has become false, calls `limitTheEnd` before it takes the node down, and
/// returns the exit code.
using RunningFn = std::function<bool()>;
int runNodeWithLoop(int& argc, char** argv, const NodeUsage& usage,
                    const std::function<int(ros::NodeHandle&, ros::NodeHandle&, const RunningFn&)>& body,
                    const std::function<void()>& check = {});

}  // namespace frontier_pilot
