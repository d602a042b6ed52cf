#pragma once

#include <functional>
#include <optional>
#include <string>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// The node that a map belongs to, and whether it still lives. [FLT-1]
class MapOwner {
 public:
  /// Whether a node lives, as was found out after `since`; nothing as long as nobody knows.
  using Question = std::function<std::optional<bool>(const std::string& node, SteadyTime since)>;

  /// Empty before the first message.
  const std::string& name() const { return name_; }
  /// `node`, which is the owner from now on, has sent a message.
  void hear(const std::string& node, SteadyTime now);
  /// Whether the owner lives. What `question` gives counts once it has been silent for five seconds. In doubt it lives,
  /// as while there is no master; once it was found dead, it is so until it is heard again.
  bool lives(SteadyTime now, const Question& question);

 private:
  std::string name_;
  SteadyTime heard_{};  ///< when it last sent a message, or was found alive
  bool dead_ = false;
};

}  // namespace frontier_pilot
