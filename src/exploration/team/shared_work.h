#pragma once

#include <cstddef>
#include <optional>
#include <unordered_map>
#include <vector>

#include "exploration/observed_map.h"
#include "frontier_pilot/exploration/explorer_types.h"

namespace frontier_pilot::exploration {

/// Which frontiers a robot leaves to the others of its team: those that another one claims and sees sooner, by what
/// both say. Every robot decides for itself, by the last claims of the others, and makes its own known; that converges
/// because a cost only grows with what else a robot takes on (Choi, Brunet & How, "Consensus-Based Decentralized
/// Auctions for Robust Task Allocation", IEEE Transactions on Robotics 25(4), 2009). A frontier is taken over from the
/// robot that claims it only for a clear advantage, so that it does not change hands back and forth. [MUL-2]
class SharedWork {
 public:
  /// What the others say now, in the map's frame.
  void setOthers(const std::vector<Teammate>& others);
  /// What the robot itself has claimed by now.
  void setOwn(const std::vector<Claim>& claims) { own_ = claims; }
  /// To be called when the map has changed, or the claims have.
  void restart() { rivals_.clear(); }

  /// Whether there is no other robot.
  bool alone() const { return others_.empty(); }
  /// Whether another robot has something to look at.
  bool othersHaveWork() const;
  /// Whether a robot that can see the frontier with this anchor in `cost` [s] leaves it to another one.
  bool leaves(Cell anchor, double cost, const ObservedMap& map);

 private:
  /// The claim of another robot on a frontier.
  struct Rival {
    double cost = 0.0;  ///< [s]
    bool precedes = false;
  };
  const std::optional<Rival>& rivalFor(Cell anchor, const ObservedMap& map);
  std::optional<Rival> findRival(Cell anchor, const ObservedMap& map) const;
  bool holds(const Vec2& place) const;

  std::vector<Teammate> others_;
  std::vector<Claim> own_;
  std::unordered_map<std::size_t, std::optional<Rival>> rivals_;  ///< by the index of the anchor
};

}  // namespace frontier_pilot::exploration
