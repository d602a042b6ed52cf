#pragma once

#include <vector>

#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/navigation/navigator_types.h"

namespace frontier_pilot::navigation {

/// Something on free floor, as the scanner sees it, in the map frame.
struct SeenThing {
  MovingDisc body;              ///< around what is seen of it; a velocity of zero: it stands
  Vec2 nearest = Vec2::Zero();  ///< the place of it that is nearest to this robot [m]
};

/// The others around a robot, and what else may move.
struct Neighbours {
  std::vector<MovingDisc> told;  ///< robots nearby that moved between their last two messages
  std::vector<SeenThing> seen;   ///< what the scanner sees where the floor was free
};

/// What a robot with an outline at `T_map_base` has to keep off while it moves. Places are in the map frame. [MUL-3]
class NeighbourCheck {
 public:
  /// `neighbours` has to outlive it.
  NeighbourCheck(const Neighbours& neighbours, const Pose2& T_map_base, const Outline& outline);

  bool seesSomething() const { return !neighbours_.seen.empty(); }
  /// Whether `position` is away from where the others will be in `seconds`, if they drive on, or at least no nearer
  /// than if this robot stood still.
  bool isFree(const Vec2& position, double seconds) const;
  /// Whether a robot at `position` is on its side of the middle between itself and each thing that is seen. Two robots
  /// do not touch if each can brake on its own side and knows where the other one is, whatever else it knows of it: the
  /// buffered Voronoi cells of Zhou, Wang, Bandyopadhyay & Schwager (IEEE RA-L 2(2), 2017).
  bool isOnOwnSide(const Vec2& position) const;

 private:
  /// Towards something that may move, and how far the robot may go there.
  struct Side {
    Vec2 unit;
    double own;  ///< [m]
  };
  bool isFreeOf(const MovingDisc& other, const Vec2& position, double seconds) const;

  const Neighbours& neighbours_;
  std::vector<Side> sides_;
  Vec2 here_;
  double radius_;  ///< of the disc around the outline: it may turn, and so may the other one [m]
};

}  // namespace frontier_pilot::navigation
