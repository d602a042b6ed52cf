#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ros/common/memory/session_memory.h"
#include "ros/common/messages/mailbox.h"
#include "ros/common/node_connections.h"
#include "ros/common/threads/periodic_thread.h"

namespace frontier_pilot {

/// A text that the next process of this node, or of a service's provider, finds when this one has died: see
/// SessionMemory. It is written again each second, because a disk may be full for a while, and files may be deleted;
/// while there is no text it is checked whether one could be stored, so that a problem is known before it matters. That
/// is done on a thread that all texts of a process share, so that a slow disk holds up no callback. A restart of the
/// master is followed. For the thread that runs the callbacks. [FLT-2] [ARB-10]
class RememberedText {
 public:
  /// `what` names the text, in the name of its file and in the diagnostics ("nav_disabled"); `spare` is a
  /// second folder for it, as that of SessionMemory. `connections` must be destroyed before this object.
  RememberedText(std::string what, const std::string& owner, SessionMemory::Owner kind, NodeConnections& connections,
                 std::filesystem::path spare = {});
  /// After an end in order a file does not count in another session. Leaves no empty folder.
  ~RememberedText();
  RememberedText(const RememberedText&) = delete;
  RememberedText& operator=(const RememberedText&) = delete;

  /// What earlier processes have left, and those that run beside this one; one that cannot be read is empty.
  const std::vector<std::string>& left() const { return left_; }
  /// Those of them that are of another session, whose master has been replaced.
  const std::vector<std::string>& leftElsewhere() const { return left_elsewhere_; }
  /// Those of processes of this launch, of either session.
  const std::vector<std::string>& leftByThisLaunch() const { return left_by_this_launch_; }
  /// Puts `text` in the place of what was remembered before; nothing forgets it. Returns why it would not survive this
  /// process; empty if it would.
  std::string set(std::optional<std::string> text);
  /// To be called at a regular end: after it nothing is written any more, and what is kept does not count in another
  /// session. With `forget` nothing is kept. The connections may be gone by then.
  void end(bool forget);

 private:
  /// Writes the text, or looks whether one could be written. Gives why it would not survive; empty if it would.
  std::string store() const;
  void tell(const std::string& problem);

  std::string what_;
  MemoryReport& report_;
  std::vector<std::string> left_, left_elsewhere_, left_by_this_launch_;
  std::mutex mutex_;  ///< guards the three that follow
  SessionMemory memory_;
  std::optional<std::string> text_;
  bool ended_ = false;
  Mailbox<std::string> problem_;  ///< that another thread has found
  std::string warned_of_;         ///< the problem of which the log was told, as long as it lasts
  std::shared_ptr<PeriodicThread> thread_;
  int number_;  ///< of this text's function on the thread
};

}  // namespace frontier_pilot
