#pragma once

#include "frontier_pilot/behavior/local_costmap.h"
#include "frontier_pilot/behavior/timed_behavior.h"

namespace frontier_pilot::behavior {

/// The parameters of a CollisionCheck.
struct CollisionCheckParameters {
  FootprintParameters footprint;
  LocalCostmapParameters costmap;

  template <class Visitor>
  void describe(Visitor& v) {
    v.group("footprint", footprint, "what has to be free around the robot");
    v.group("costmap", costmap, "the local costmap that is built from the scan");
  }
};

/// Checks a behaviour's motion ahead: the footprint on the local costmap, as long as the last scan is recent.
class CollisionCheck {
 public:
  explicit CollisionCheck(const CollisionCheckParameters& parameters = {}, const RobotModel& robot = {})
      : footprint_(robot.exactOutline().padded(parameters.footprint.padding)),
        costmap_(parameters.costmap, footprint_) {}

  LocalCostmap& costmap() { return costmap_; }
  const LocalCostmap& costmap() const { return costmap_; }
  /// The robot's outline with the padding around it.
  const Outline& footprint() const { return footprint_; }
  /// The look-ahead for `BehaviorInputs` at `now`. It is empty, so that every motion is blocked, when the last scan is
  /// older than `max_age` [s]. [SPN-3] It refers to this object.
  LookAhead lookAhead(double max_age, Time now) const {
    const auto stamp = costmap_.stamp();
    if (!stamp || std::abs(toSeconds(now - *stamp)) > max_age) return {};
    return [this](const Pose2& T_odom_base, const AxisMotion& motion) {
      return sweep(costmap_.grid(), footprint_, T_odom_base, motion);
    };
  }

 private:
  Outline footprint_;
  LocalCostmap costmap_;
};

}  // namespace frontier_pilot::behavior
