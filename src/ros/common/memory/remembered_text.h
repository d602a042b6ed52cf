#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ros/common/memory/session_memory.h"
#include "ros/common/node_connections.h"

namespace frontier_pilot {

/// A text that the next process of this node, or of a service's provider, finds when this one has died: see
/// SessionMemory. It is written again each second, because a disk may be full for a while, and files may be deleted;
/// while there is no text it is checked whether one could be stored, so that a problem is known before it matters. A
/// restart of the master is followed. [FLT-2]
class RememberedText {
 public:
  /// `what` names the text, in the name of its file and in the diagnostics ("nav_disabled"). `connections` must be
  /// destroyed before this object.
  RememberedText(std::string what, const std::string& owner, SessionMemory::Owner kind, NodeConnections& connections);
  /// After an end in order a file does not count in another session. Leaves no empty folder.
  ~RememberedText() { end(!text_); }
  RememberedText(const RememberedText&) = delete;
  RememberedText& operator=(const RememberedText&) = delete;

  /// What earlier processes have left, and those that run beside this one; one that cannot be read is empty.
  const std::vector<std::string>& left() const { return left_; }
  /// Those of them that are of another session, whose master has been replaced.
  const std::vector<std::string>& leftElsewhere() const { return left_elsewhere_; }
  /// Puts `text` in the place of what was remembered before; nothing forgets it. Returns why it would not survive this
  /// process; empty if it would.
  std::string set(std::optional<std::string> text);
  /// To be called at a regular end: after it nothing is written any more, and what is kept does not count in another
  /// session. With `forget` nothing is kept. The connections may be gone by then.
  void end(bool forget);

 private:
  std::string write();

  std::string what_;
  MemoryReport& report_;
  std::vector<std::string> left_, left_elsewhere_;
  std::mutex mutex_;  ///< guards the four that follow
  SessionMemory memory_;
  std::optional<std::string> text_;
  bool ended_ = false;
  std::string warned_of_;  ///< the problem of which the log was told, as long as it lasts
};

}  // namespace frontier_pilot
