#pragma once

#include <cstdint>
#include <optional>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/mapping/parameters.h"

namespace frontier_pilot::mapping {

/// Odometry without its jumps. No robot drives 10 m between two messages: its driver was started again and counts from
/// the origin, somebody set it, or the message is wrong. A single such message is left out; when the next ones go on
/// from there, odometry has been reset, and the robot is believed to stand where it stood. So whatever is anchored to
/// this odometry stays where it is, and scan matching corrects the little that the robot moved meanwhile. [FLT-1]
/// Odometry that is trusted, as that of a simulator, knows better: it jumps when the robot was put somewhere else.
/// Messages that were lost make no jump: what may be driven grows with the time between the stamps.
class OdometryAnchor {
 public:
  /// By what odometry jumped, and in what time between two stamps.
  struct Jump {
    double distance = 0.0;  ///< [m]
    double turn = 0.0;      ///< [rad]
    double seconds = 0.0;
  };

  explicit OdometryAnchor(const OdometryAnchorParameters& parameters = {}) : parameters_(parameters) {}

  /// The pose without the jumps so far, `T_smooth_base`; none while it is not clear whether this one is a mistake.
  std::optional<Pose2> follow(Time stamp, const Pose2& T_odom_base);
  /// Where odometry's frame lies in the one without jumps: changes with each reset.
  const Pose2& T_smooth_odom() const { return T_smooth_odom_; }
  std::uint64_t resets() const { return resets_; }
  const Jump& lastJump() const { return last_jump_; }

  /// The clock was set: what comes next is compared with nothing.
  void forgetTime();
  /// Both frames are one again.
  void reset();

 private:
  bool isDrivable(const StampedPose2& from, const StampedPose2& to) const;
  bool isRestart(const StampedPose2& from, const StampedPose2& to) const;
  std::optional<Pose2> accept(const StampedPose2& sample);
  std::optional<Pose2> confirmLater(const StampedPose2& sample);

  OdometryAnchorParameters parameters_;
  Pose2 T_smooth_odom_;
  std::optional<StampedPose2> last_;         ///< the odometry, T_odom_base, that was believed last
  std::optional<StampedPose2> landing_;      ///< the first one after a jump that may be a mistake
  std::optional<StampedPose2> unconfirmed_;  ///< the last one since then
  int followers_ = 0;                        ///< how many have gone on from there
  std::uint64_t resets_ = 0;
  Jump last_jump_;
};

}  // namespace frontier_pilot::mapping
