#pragma once

#include <vector>

#include "frontier_pilot/navigation/navigator_types.h"

namespace frontier_pilot::navigation {

/// The others around a robot, and where it may be because of them. [MUL-3]
struct Neighbours {
  std::vector<MovingDisc> told;  ///< robots nearby that say that they drive
  std::vector<MovingDisc> seen;  ///< what the scanner sees where the floor was free, standing or moving

  bool empty() const { return told.empty() && seen.empty(); }
};

/// What a robot at `here` whose outline is within `radius` [m] has to keep off while it moves. All in the map frame.
class NeighbourCheck {
 public:
  NeighbourCheck(const Neighbours& neighbours, const Vec2& here, double radius)
      : neighbours_(neighbours), here_(here), radius_(radius) {}

  /// Whether `position` is away from where the others will be in `seconds`, if they drive on, or at least no nearer
  /// than if this robot stood still.
  bool isFree(const Vec2& position, double seconds) const;
  /// Whether this robot stays on its side of the middle between it and each thing that is seen. Two robots of which
  /// each can brake on its own side do not touch, whatever either of them knows of the other's plans: the buffered
  /// Voronoi cells of Zhou, Wang, Bandyopadhyay & Schwager (IEEE RA-L 2(2), 2017).
  bool isOnOwnSide(const Vec2& position) const;
  bool empty() const { return neighbours_.empty(); }

 private:
  bool isFreeOf(const MovingDisc& other, const Vec2& position, double seconds) const;

  const Neighbours& neighbours_;
  Vec2 here_;
  double radius_;
};

}  // namespace frontier_pilot::navigation
