#pragma once

#include <cstdint>
#include <unordered_map>

#include "exploration/observed_map.h"

namespace frontier_pilot::exploration {

/// Tells frontiers in passages from those in rooms. In a maze, whose corridors lead on behind every corner, the area
/// in sight behind a frontier tells nothing of what lies there. What was found is kept until the map nearby changes.
class Passages {
 public:
  /// Whether the known floor near a frontier cell, as far as it is in sight, is nowhere wider than a passage.
  bool contains(Cell frontier, const ObservedMap& map);

 private:
  struct Judgement {
    std::uint64_t changes = 0;  ///< of the map nearby, plus one; 0: not judged yet
    bool in_passage = false;
  };
  GridGeometry geometry_;  ///< of the judged cells
  std::unordered_map<std::size_t, Judgement> judged_;
};

}  // namespace frontier_pilot::exploration
