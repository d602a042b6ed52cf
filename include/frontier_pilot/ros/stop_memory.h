#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace frontier_pilot {

/// Keeps an emergency stop over the death of its node: a file in ROS_HOME that bears the name of the node and the id of
/// the ROS session, so that a new session starts afresh.
///
/// A file and not a parameter: writing it takes microseconds and needs nobody, while a write to the parameter server
/// waits for ever when the master is gone, and with it the zeros would stop. [ARB-7]
class StopMemory {
 public:
  /// `session` names the ROS session, `node` the resolved node name.
  StopMemory(const std::filesystem::path& ros_home, const std::string& session, const std::string& node);

  /// From now on in another session of ROS; gives whether it is another one.
  bool enter(const std::string& session);
  /// Why it was stopped, if it was.
  std::optional<std::string> recall() const;
  /// Once this has returned an empty text the stop survives the process; otherwise the text says why it does not.
  std::string remember(const std::string& cause) const;
  /// Once this has returned an empty text a new process comes up free; otherwise the text says why it does not.
  std::string forget() const;

 private:
  std::filesystem::path ros_home_;
  std::string node_;
  std::filesystem::path file_;
};

/// ROS_HOME, or what ROS takes in its place.
std::filesystem::path rosHome();
/// What tells this ROS session from any other: the run id that roslaunch gives its master, or the master's process.
std::string rosSession();

}  // namespace frontier_pilot
