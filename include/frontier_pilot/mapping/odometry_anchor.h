#pragma once

#include <cstdint>
#include <optional>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/mapping/parameters.h"

namespace frontier_pilot::mapping {

/// Odometry without its jumps. A message is a jump if it lies farther from the last one than `max_speed` and
/// `max_turn_rate` allow, plus 0.5 m and 0.5 rad, or if after more than 1 s of silence it lies exactly at the origin:
/// the driver was restarted and counts from there, somebody set its pose, or the message is wrong. A single such
/// message is left out; if the next two continue from there, odometry was reset, and the robot is taken to be where it
/// was before. So everything anchored to this odometry stays in place, and scan matching corrects the little that the
/// robot moved meanwhile. [FLT-1] The jumps of trusted odometry, as of a simulator, are real and followed: the robot
/// was moved. Lost messages alone do not look like a jump: the distance that may be driven grows with the time between
/// the stamps.
class OdometryAnchor {
 public:
  /// What is wrong with a message that is withheld.
  static constexpr const char* kWithheld = "farther from the last message than a robot can drive in that time";

  /// A jump of odometry, and the time between the stamps before and after it.
  struct Jump {
    double distance = 0.0;  ///< [m]
    double turn = 0.0;      ///< [rad]
    double seconds = 0.0;
  };

  explicit OdometryAnchor(const OdometryAnchorParameters& parameters = {}) : parameters_(parameters) {}

  /// The pose without the jumps so far, `T_smooth_base`; none while it is open whether this message is a mistake.
  std::optional<Pose2> follow(Time stamp, const Pose2& T_odom_base);
  /// The pose of the odometry frame in the frame without jumps; changes with each reset of untrusted odometry.
  const Pose2& T_smooth_odom() const { return T_smooth_odom_; }
  /// Whether jumps are real and followed.
  bool followsJumps() const { return parameters_.trusted; }
  /// How often odometry has jumped for good, trusted or not.
  std::uint64_t resets() const { return resets_; }
  const Jump& lastJump() const { return last_jump_; }

  /// The clock was set: the next message is not compared with earlier ones.
  void forgetTime();
  /// Forgets all jumps: both frames are the same again.
  void reset();

 private:
  bool isDrivable(const StampedPose2& from, const StampedPose2& to) const;
  bool isRestart(const StampedPose2& from, const StampedPose2& to) const;
  std::optional<Pose2> accept(const StampedPose2& sample);
  std::optional<Pose2> confirmLater(const StampedPose2& sample);

  OdometryAnchorParameters parameters_;
  Pose2 T_smooth_odom_;
  std::optional<StampedPose2> last_;         ///< the T_odom_base that was accepted last
  std::optional<StampedPose2> landing_;      ///< the first one after a jump that may be a mistake
  std::optional<StampedPose2> unconfirmed_;  ///< the last one since then
  int followers_ = 0;                        ///< number of messages that continued from there
  std::uint64_t resets_ = 0;
  Jump last_jump_;
};

}  // namespace frontier_pilot::mapping
