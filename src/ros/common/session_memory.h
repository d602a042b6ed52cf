#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace frontier_pilot {

/// Keeps what an operator said over the death of the node that it was said to, such as an emergency stop: a file in
/// ROS_HOME that bears the name of its owner and the id of the ROS session, so that a new session starts afresh. What
/// was written in another session less than ten seconds before this process began counts as well, if its writer died
/// and this process was started in its place, by the same roslaunch: master and node died together, and what drives the
/// robot may have outlived both.
///
/// A file and not a parameter: writing it takes microseconds and needs nobody, while a write to the parameter server
/// waits for ever when the master is gone, and with it the zeros would stop. [ARB-7]
class SessionMemory {
 public:
  /// Who the owner in a file's name is.
  enum class Owner {
    kNode,     ///< a resolved node name: each process overwrites the file of the one before it
    kService,  ///< a resolved service name, which nodes of any name may offer one after the other, or even at once:
               ///< each process writes a file of its own, and none removes what a living one has written [ARB-12]
  };

  /// `sessions` are the names of the ROS session, of which any may change alone; `what` names the thing that is
  /// remembered, in characters of a file name.
  SessionMemory(const std::filesystem::path& ros_home, const std::vector<std::string>& sessions, std::string what,
                std::string owner, Owner kind);

  /// From now on in another session of ROS; gives whether it is another one.
  bool enter(const std::vector<std::string>& sessions);
  /// The text that was remembered, if one was: the cause of a stop. Of several the first.
  std::optional<std::string> recall() const;
  /// What this process and those before it and beside it have remembered.
  std::vector<std::string> recallAll() const;
  /// What others have remembered in this session, after this process has said something itself.
  std::optional<std::string> recallOthers() const;
  /// The file that holds it.
  std::optional<std::filesystem::path> find() const;
  /// Once this has returned an empty text `text` survives the process; otherwise it gives why it does not. It takes the
  /// place of what the dead have remembered.
  std::string remember(const std::string& text) const;
  /// Why nothing could be remembered now; empty: nothing is in the way. Makes the folder.
  std::string problem() const;
  /// Once this has returned an empty text a new process finds nothing but what living ones remember; otherwise it gives
  /// why it does.
  std::string forget() const;
  /// The node ends in order: another session shall not find what it kept.
  void endInOrder() const;
  /// Where the text is kept, once for each name of the session.
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  std::vector<std::filesystem::path> others() const;
  std::vector<std::filesystem::path> all() const;
  /// Gives what went wrong, or an empty text.
  std::string removeThoseOfTheDead() const;

  std::filesystem::path ros_home_;
  std::string name_;                              ///< of the files, or how their names begin
  Owner kind_;                                    ///< of whom that name tells
  std::vector<std::filesystem::path> files_;      ///< the same for each name of the session
  std::vector<std::filesystem::path> elsewhere_;  ///< of another session, until this node has said something itself
};

/// ROS_HOME, or what ROS takes in its place.
std::filesystem::path rosHome();
/// What tells this ROS session from any other: the run id that roslaunch gives its master, which is a parameter and can
/// be deleted, and the master's process.
std::vector<std::string> rosSessions();

}  // namespace frontier_pilot
