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
  /// `neighbours` and `outline` have to outlive it.
  NeighbourCheck(const Neighbours& neighbours, const Pose2& T_map_base, const Outline& outline);

  bool seesSomething() const { return !neighbours_.seen.empty(); }
  /// Whether `position` is away from where the others will be in `seconds`, if they drive on, or at least no nearer
  /// than if this robot stood still.
  bool isFree(const Vec2& position, double seconds) const;
  /// Whether the whole outline at `pose` is on its side of the middle between itself and each thing that is seen. Two
  /// robots do not touch if each can brake on its own side and knows where the other one is, whatever else it knows of
  /// it: the buffered Voronoi cells of Zhou, Wang, Bandyopadhyay & Schwager (IEEE RA-L 2(2), 2017).
  bool isOnOwnSide(const Pose2& pose) const;
  /// The same for the outline alone, without the room for a turn on the spot: for a robot that backs out of a narrow
  /// place.
  bool isOutlineOnOwnSide(const Pose2& pose) const;

 private:
  /// The border with something that may move: for the disc around this robot, which it may fill by a turn, and for its
  /// outline, whose corners swing out while it turns.
  struct Border {
    Vec2 ahead;       ///< from this robot's centre
    double farthest;  ///< coordinate of its centre along that [m]
    Vec2 across;      ///< from the nearest place of its outline
    double widest;    ///< coordinate along that of any part of it [m]
  };
  double reachAlong(const Vec2& unit, const Pose2& pose) const;
  bool keeps(const Border& border, const Pose2& pose) const;
  bool isFreeOf(const MovingDisc& other, const Vec2& position, double seconds) const;

  const Neighbours& neighbours_;
  const Outline& outline_;
  std::vector<Border> borders_;
  Vec2 here_;
};

}  // namespace frontier_pilot::navigation
