#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <memory>

namespace frontier_pilot {

/// A node's life: `make(node, private_node)` builds it, then callbacks run on this one thread until SIGINT, SIGTERM or
/// a ROS shutdown; the node is destroyed while its publishers still work, so that a destructor's last words get out.
/// What a callback throws is said on the log, and the node goes on. What `make` throws is said on the log and on
/// stderr, and ends the node. Gives the exit code: 0, or 1 after an exception, or 2 for a ConfigurationError. Before
/// the node is known to the master a living node of the same name is such an exception, and what `check` throws.
int runNode(int argc, char** argv, const std::string& name,
            const std::function<std::shared_ptr<void>(ros::NodeHandle&, ros::NodeHandle&)>& make,
            const std::function<void()>& check = {});

/// The same for a class with a constructor `Node(ros::NodeHandle& node, ros::NodeHandle& private_node)`.
template <class Node>
int runNode(int argc, char** argv, const std::string& name, const std::function<void()>& check = {}) {
  return runNode(
      argc, argv, name,
      [](ros::NodeHandle& node, ros::NodeHandle& private_node) { return std::make_shared<Node>(node, private_node); },
      check);
}

/// The same for a node with a main loop of its own, such as a window's: `body(node, private_node, running)` is the
/// whole of it, has to end soon after `running()` has become false, and gives the exit code.
using RunningFn = std::function<bool()>;
int runNodeWithLoop(int& argc, char** argv, const std::string& name,
                    const std::function<int(ros::NodeHandle&, ros::NodeHandle&, const RunningFn&)>& body,
                    const std::function<void()>& check = {});

}  // namespace frontier_pilot
