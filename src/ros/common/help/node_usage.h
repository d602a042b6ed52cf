#pragma once

#include <ros/message_traits.h>
#include <ros/service_traits.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot {

/// The name of a topic, service or action, and its ROS type.
struct NamedPort {
  std::string name, type;
};

/// `T` is a message, or the action message that names an action (`move_base_msgs::MoveBaseAction`).
template <class T>
NamedPort port(const std::string& name) {
  return {name, ros::message_traits::DataType<T>::value()};
}
template <class Service>
NamedPort servicePort(const std::string& name) {
  return {name, ros::service_traits::DataType<Service>::value()};
}

/// What a node says of itself when it is called with --help.
struct NodeUsage {
  std::string name;
  std::string purpose;                                                   ///< whole sentences, with line breaks
  std::string arguments = "[_PARAMETER:=VALUE ...] [TOPIC:=OTHER ...]";  ///< of the command line
  std::string options;                                                   ///< what these are; empty: nothing more to say
  std::vector<NamedPort> reads, publishes, services, actions;
  std::vector<NamedPort> calls;                    ///< services and actions of other nodes
  std::vector<std::string> main_parameters;        ///< the names of those that most people change
  std::vector<detail::Describer::Row> parameters;  ///< all of them; empty: the node has none
  std::string exit_codes =
      "  0    ended by a signal or with ROS\n"
      "  1    it could not start: the reason is printed\n"
      "  2    wrong arguments or parameters: each is named\n";
  std::string example;                       ///< one line or several
  std::vector<std::string> library_options;  ///< options with a value that a library of the node reads
};

/// Adds the topics and the service of a node whose parameters may change while it runs (ReconfigureServer).
void addTuningPorts(NodeUsage& usage);

/// The rows of `rows` that `names` lists, in the order of `rows`. Items of a list match the name `list[i]/...`: the
/// first one stands for all, with their values side by side where they differ.
std::vector<detail::Describer::Row> rowsNamed(const std::vector<detail::Describer::Row>& rows,
                                              const std::vector<std::string>& names);

/// Items of lists as one row `list[i]/...` for all items, with their values side by side where they differ.
std::vector<detail::Describer::Row> withOneItem(const std::vector<detail::Describer::Row>& rows);

/// The text of --help.
std::string helpOf(const NodeUsage& usage);

/// Prints the help of a node. Returns its exit code: 1 if the help cannot be written, which is said on stderr.
int printHelp(const NodeUsage& usage);

/// Prints the text of --help when `words` (without the program's name) ask for it, and one line on stderr for the first
/// word that is neither a remapping (`a:=b`, `_parameter:=value`, `__name:=x`) nor one of the library's options.
/// Returns the exit code, 0 or 2; std::nullopt if the node is to run.
std::optional<int> answerCommandLine(const std::vector<std::string>& words, const NodeUsage& usage);

}  // namespace frontier_pilot
