#pragma once

#include <optional>
#include <vector>

#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/planning/clearance_map.h"
#include "frontier_pilot/planning/path.h"

namespace frontier_pilot::planning {

/// Whether an outline that is not a disc fits where it drives and turns. A ClearanceMap for a disc as wide as the robot
/// covers the lane of a straight motion; this class adds the corners, which reach beyond that disc: each of the
/// outline's points, `kSpacing` apart, has to keep the distance from obstacles that the map requires in addition to its
/// disc's radius. Poses are T_map_base.
class OutlineCheck {
 public:
  /// For a robot that is a disc: the outline fits wherever the map allows it.
  OutlineCheck() = default;
  /// For this outline on maps for a disc of `outline.halfWidth()`.
  explicit OutlineCheck(const Outline& outline);

  bool isTrivial() const { return points_.empty(); }
  /// The same check with the smaller distances that a ClearanceMap allows in tight places: corners may be too thick in
  /// the map, and there the follower decides by the live scan.
  OutlineCheck inTightPlaces() const;
  /// Whether the outline fits at a pose; `slack` [m] is how much nearer to obstacles than on a path its points may
  /// come.
  bool fits(const ClearanceMap& map, const Pose2& T_map_base, double slack = 0.0) const;
  /// Whether the robot can turn on the spot from one direction [rad] to the other, the shorter way.
  bool canTurn(const ClearanceMap& map, const Vec2& position, double from, double to, double slack = 0.0) const;
  /// Whether the robot can turn right round.
  bool canTurnRound(const ClearanceMap& map, const Vec2& position) const;
  /// Whether it fits at both ends of a straight motion, whose lane the map covers.
  bool canDrive(const ClearanceMap& map, const Vec2& from, const Vec2& to) const;
  /// Whether it can follow a path by straight motions and turns on the spot, from `along` [m] on. The first `escape`
  /// segments are exempt. With `robot`, where it is now, the turn into the path's direction counts too.
  bool canFollow(const ClearanceMap& map, const Path& path, std::size_t escape, double along = 0.0,
                 const std::optional<Pose2>& robot = std::nullopt) const;

  /// A robot whose outline does not fit where it is, because the map or its pose has changed, may come as near to
  /// obstacles as it is until it has left that place.
  class Leave {
   public:
    Leave() = default;
    Leave(const OutlineCheck& outline, const ClearanceMap& map, const std::optional<Pose2>& robot);
    /// How much nearer to obstacles than on a path the outline may come at `position` [m].
    double slackAt(const Vec2& position) const;

   private:
    Vec2 position_ = Vec2::Zero();
    double slack_ = 0.0;
  };

 private:
  static constexpr double kSpacing = 0.03;   ///< [m]
  static constexpr double kTurnStep = 0.02;  ///< that the farthest point moves between two checks of a turn [m]

  double neededClearance(const ClearanceMap& map) const;
  /// Whether the map tells of so much clearance there that the robot fits in every direction.
  bool isWideOpen(const ClearanceMap& map, const Vec2& position) const;

  std::vector<Vec2> points_;  ///< of the outline, in the base frame, those inside of the map's disc left out
  double reach_ = 0.0;        ///< of the farthest [m]
  bool tight_ = false;
};

}  // namespace frontier_pilot::planning
