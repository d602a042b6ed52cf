#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Whether the nodes that follow the emergency stop can know of one yet. To an arbiter that has just started they
/// connect one after the other, and who connects only after a clear has never heard of the stop: its goal goes on.
/// Those are the nodes that the master lists as subscribers, and that live. One that hangs, or cannot be reached, is
/// waited for in vain, so not for ever. [ARB-8] [FLT-2]
class StopListeners {
 public:
  explicit StopListeners(std::string self) : self_(std::move(self)) {}

  /// From `now` on they can connect.
  void begin(SteadyTime now) { begun_ = now; }
  SteadyTime begun() const { return begun_; }
  void connect(const std::string& node) { connected_.insert(node); }
  void disconnect(const std::string& node);
  /// The living subscribers of the latest look at the master.
  void list(std::vector<std::string> nodes) { listed_ = std::move(nodes); }

  /// Whether one of them may still be about to connect.
  bool areAwaited(SteadyTime now) const;
  /// False once that is over, whoever is connected.
  bool mayBeAwaited(SteadyTime now) const;

 private:
  std::string self_;
  SteadyTime begun_{};
  std::multiset<std::string> connected_;  ///< a node may connect again before its old connection has ended
  std::optional<std::vector<std::string>> listed_;
};

}  // namespace frontier_pilot
