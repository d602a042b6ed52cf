#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace frontier_pilot {

/// Keeps an operator's request, such as an emergency stop, beyond the death of the node that received it: in a file
/// under ROS_HOME whose path contains the owner's name and the id of the ROS session, so that a new session starts
/// afresh. A file of another session also counts if its writer died and this process was started in its place by the
/// same roslaunch: then the node has outlived its master, or died together with it, and the nodes that drive the robot
/// may have outlived both. Such a file counts however long afterwards, unless the kind of owner says otherwise.
///
/// It is a file and not a parameter because writing it takes microseconds and depends on no other process. A write to
/// the parameter server would wait forever while the master is gone, and meanwhile the arbiter would send no zeros.
/// A disk that hangs, such as one of a server that is away, is waited for 50 ms, and not again before it answers; only
/// construction and recall, with which a node starts, wait for it. The spare folder is in memory and does not hang.
/// [ARB-7]
class SessionMemory {
 public:
  /// What kind of name the owner has, which is part of the file's name.
  enum class Owner {
    kNode,         ///< a resolved node name: each process overwrites the file of the one before it. That of another
                   ///< session counts only if it was written less than ten seconds before this process began
    kLastingNode,  ///< a resolved node name, but the file of another session counts however old it is
    kService,  ///< a resolved service name, which several nodes may offer one after the other, or even at once: each
               ///< process writes a file of its own, and none removes the file of a living process [ARB-12]
  };

  /// `sessions` are the names of the ROS session, see master/ros_sessions.h, of which one may change without the other;
  /// what is no plain name of a folder names no session.
  /// `what` names what is remembered and has to be usable in a file name. With `spare`, a folder on another file
  /// system, such as spareFolder(), everything is written there too, and a home that is full or read-only loses
  /// nothing.
  SessionMemory(std::filesystem::path ros_home, const std::vector<std::string>& sessions, std::string what,
                std::string owner, Owner kind, std::filesystem::path spare = {});

  /// Changes to the ROS session with these names; returns whether it is another one than before. Without a name it
  /// stays in the one that it is in.
  bool enter(const std::vector<std::string>& sessions);
  /// The remembered text, such as the cause of a stop; the first one that can be read if there are several, empty if
  /// none of them can. Nothing if there is none.
  std::optional<std::string> recall() const;
  /// The texts remembered by this process, by earlier ones and by those that run at the same time.
  std::vector<std::string> recallAll() const;
  /// The texts of other sessions, whose writers this process replaces.
  std::vector<std::string> recallFromElsewhere() const;
  /// Those of recallAll() whose writers were of this launch, see ProcessIdentity::isOfThisLaunch(): after the computer
  /// was switched off, or in another launch at the same master, there are none.
  std::vector<std::string> recallOfThisLaunch() const;
  /// The first text that another process, living or dead, has remembered in this session; nothing if there is none.
  std::optional<std::string> recallOthers() const;
  /// The files with the texts that recallAll() returns.
  std::vector<std::filesystem::path> findAll() const;
  /// Stores `text`, in place of what dead processes have remembered; what is not printable in it is escaped, and of one
  /// that is longer than 128 KiB the beginning is stored. Returns an empty text if it will survive this
  /// process, otherwise why it will not.
  std::string remember(const std::string& text) const;
  /// Why nothing could be stored now; empty if it could. Creates the folder.
  std::string problem() const;
  /// Removes what this process and dead ones have remembered; files of other living processes stay. Returns an empty
  /// text, or why some could not be removed.
  std::string forget() const;
  /// The same below ROS_HOME alone, on the thread that calls it, however long the disk hangs.
  std::string forgetPatiently() const;
  /// To be called at a regular shutdown: a process of another session will then ignore what this one has stored.
  void endInOrder() const;
  /// The files of this process, one for each name of the session.
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  std::vector<std::filesystem::path> filesIn(const std::filesystem::path& root,
                                             const std::vector<std::string>& sessions) const;
  /// Those of this process, at both places.
  std::vector<std::filesystem::path> own() const;
  std::vector<std::filesystem::path> others() const;
  /// Returns what went wrong; empty if nothing did.
  std::string removeThoseOfTheDead() const;

  std::filesystem::path ros_home_;
  std::filesystem::path spare_;                   ///< empty if there is none
  std::string name_;                              ///< of the files; with kService the process id follows it
  Owner kind_;                                    ///< what kind of name the owner has
  std::vector<std::filesystem::path> files_;      ///< of this process, one for each name of the session
  std::vector<std::filesystem::path> spares_;     ///< the same files below spare_
  std::vector<std::filesystem::path> elsewhere_;  ///< of other sessions, removed once this process stores or forgets
};

/// Whether the process that has written `file`, a file of a SessionMemory, lives; false if there is no such file.
bool isKeptByALivingProcess(const std::filesystem::path& file);

}  // namespace frontier_pilot
