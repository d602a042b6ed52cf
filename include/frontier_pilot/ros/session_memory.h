#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace frontier_pilot {

/// Keeps what an operator said over the death of the node that it was said to, such as an emergency stop: a file in
/// ROS_HOME that bears the name of the node and the id of the ROS session, so that a new session starts afresh. What
/// was written in another session less than ten seconds before this process began counts as well, if its writer died
/// and this process was started in its place, by the same roslaunch: master and node died together, and what drives the
/// robot may have outlived both.
///
/// A file and not a parameter: writing it takes microseconds and needs nobody, while a write to the parameter server
/// waits for ever when the master is gone, and with it the zeros would stop. [ARB-7]
class SessionMemory {
 public:
  /// `sessions` are the names of the ROS session, of which any may change alone; `node` is the resolved node name;
  /// `what` names the thing that is remembered, in characters of a file name.
  SessionMemory(const std::filesystem::path& ros_home, const std::vector<std::string>& sessions, std::string what,
                std::string node);

  /// From now on in another session of ROS; gives whether it is another one.
  bool enter(const std::vector<std::string>& sessions);
  /// The text that was remembered, if one was: the cause of a stop.
  std::optional<std::string> recall() const;
  /// The file that holds it.
  std::optional<std::filesystem::path> find() const;
  /// Once this has returned an empty text `text` survives the process; otherwise it gives why it does not.
  std::string remember(const std::string& text) const;
  /// Once this has returned an empty text a new process finds nothing; otherwise it gives why it does.
  std::string forget() const;
  /// The node ends in order: another session shall not find what it kept.
  void endInOrder() const;
  /// Where the text is kept, once for each name of the session.
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  std::filesystem::path ros_home_;
  std::string name_;                              ///< of the files
  std::vector<std::filesystem::path> files_;      ///< the same for each name of the session
  std::vector<std::filesystem::path> elsewhere_;  ///< of another session, until this node has said something itself
};

/// ROS_HOME, or what ROS takes in its place.
std::filesystem::path rosHome();
/// What tells this ROS session from any other: the run id that roslaunch gives its master, which is a parameter and can
/// be deleted, and the master's process.
std::vector<std::string> rosSessions();

}  // namespace frontier_pilot
