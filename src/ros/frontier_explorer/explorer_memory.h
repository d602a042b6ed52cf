#pragma once

#include <optional>
#include <string>

#include "frontier_pilot/exploration/parameters.h"
#include "ros/common/memory/remembered_text.h"

namespace frontier_pilot {

/// The bounds on one line, and back; nothing if the text is not one of them, or something is wrong with the bounds.
std::string toText(const exploration::ExplorationBounds& bounds);
std::optional<exploration::ExplorationBounds> boundsIn(const std::string& text);

/// What an operator has told an explorer, and whether a stopping rule has ended its exploration, beyond the death of
/// the node: the next one must neither leave the bounds nor drive off again. All is forgotten at a regular shutdown.
/// (That it is paused is a SafeSwitch.) [FLT-2] [EXP-10]
class ExplorerMemory {
 public:
  explicit ExplorerMemory(NodeConnections& connections);
  ~ExplorerMemory() { end(); }
  ExplorerMemory(const ExplorerMemory&) = delete;
  ExplorerMemory& operator=(const ExplorerMemory&) = delete;

  /// What the process before this one has left.
  struct Left {
    std::optional<exploration::ExplorationBounds> bounds;
    std::optional<bool> returns_to_start;
    std::string why_stand;  ///< why the next process must not explore by itself; empty if it may
  };
  Left left() const;

  /// The text to append to an answer: why the bounds, or the way home, would not survive this node; empty if they
  /// would.
  std::string keepBounds(const exploration::ExplorationBounds& bounds);
  std::string keepReturnToStart(bool returns);
  /// The rule that has ended the exploration; nothing once it goes on.
  void keepEnd(const std::optional<std::string>& reason);
  /// Forgets all of it: a regular end.
  void end();

 private:
  RememberedText bounds_, return_, end_;
  std::optional<std::string> ended_;  ///< as it was kept last
};

}  // namespace frontier_pilot
