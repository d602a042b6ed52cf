#include <algorithm>
#include <cmath>

#include "frontier_pilot/behavior/collision_check.h"
#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::behavior {
namespace {

/// The chord is driven in the direction that the robot has in the middle of the piece.
SweepResult lookAlongChord(const LookAhead& look_ahead, const Pose2& T_odom_base, const Twist2& piece) {
  const double half = 0.5 * piece.angular;
  const double chord = half == 0.0 ? piece.linear : piece.linear * std::sin(half) / half;
  const Pose2 T_odom_chord = T_odom_base * Pose2(0.0, 0.0, half);
  if (chord != 0.0) {
    const SweepResult line = look_ahead(T_odom_chord, {AxisMotion::Axis::kLine, chord});
    if (line == SweepResult::kObstacle || piece.angular == 0.0) return line;
  }
  return look_ahead(T_odom_chord * Pose2(chord, 0.0, -half), {AxisMotion::Axis::kTurn, piece.angular});
}

}  // namespace

SweepResult lookAlongArc(const LookAhead& look_ahead, const Pose2& T_odom_base, const Twist2& arc) {
  constexpr double kMostTurn = 0.25;  // of a piece [rad]
  constexpr double kMostPieces = 100.0;
  const bool is_one = arc.linear == 0.0 || arc.angular == 0.0;
  const double pieces = is_one ? 1.0 : std::clamp(std::ceil(std::abs(arc.angular) / kMostTurn), 1.0, kMostPieces);
  SweepResult seen = SweepResult::kClear;
  for (double done = 0.0; done < pieces && (seen == SweepResult::kClear || seen == SweepResult::kUnseen); ++done) {
    seen = lookAlongChord(look_ahead, integrate(T_odom_base, arc, done / pieces),
                          {arc.linear / pieces, arc.angular / pieces});
  }
  return seen;
}

}  // namespace frontier_pilot::behavior
