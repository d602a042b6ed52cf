#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace frontier_pilot {

/// Keeps an emergency stop over the death of its node: a file in ROS_HOME that bears the name of the node and the id of
/// the ROS session, so that a new session starts afresh.
///
/// A file and not a parameter: writing it takes microseconds and needs nobody, while a write to the parameter server
/// waits for ever when the master is gone, and with it the zeros would stop. [ARB-7]
class StopMemory {
 public:
  /// `sessions` are the names of the ROS session, of which any may change alone; `node` is the resolved node name.
  StopMemory(const std::filesystem::path& ros_home, const std::vector<std::string>& sessions, const std::string& node);

  /// From now on in another session of ROS; gives whether it is another one.
  bool enter(const std::vector<std::string>& sessions);
  /// Why it was stopped, if it was.
  std::optional<std::string> recall() const;
  /// Once this has returned an empty text the stop survives the process; otherwise the text says why it does not.
  std::string remember(const std::string& cause) const;
  /// Once this has returned an empty text a new process comes up free; otherwise the text says why it does not.
  std::string forget() const;

 private:
  std::filesystem::path ros_home_;
  std::string node_;
  std::vector<std::filesystem::path> files_;  ///< the same for each name of the session
};

/// ROS_HOME, or what ROS takes in its place.
std::filesystem::path rosHome();
/// What tells this ROS session from any other: the run id that roslaunch gives its master, which is a parameter and can
/// be deleted, and the master's process.
std::vector<std::string> rosSessions();

}  // namespace frontier_pilot
