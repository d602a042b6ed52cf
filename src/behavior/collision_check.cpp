#include "frontier_pilot/behavior/collision_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "behavior/local_costmap.h"
#include "behavior/sweep.h"
#include "frontier_pilot/core/motion.h"

namespace frontier_pilot::behavior {
namespace {

constexpr double kJump = 0.5;        ///< farther than the robot can have driven [m]
constexpr double kAngleJump = 1.5;   ///< [rad]
constexpr double kLongestGap = 1.0;  ///< between two scans; the robot counts as moving no longer than this [s]

}  // namespace

struct CollisionCheck::Impl {
  Impl(const CollisionCheckParameters& parameters, const RobotModel& robot)
      : footprint(robot.exactOutline().padded(parameters.footprint.padding)),
        limits(robot.limits),
        window(parameters.costmap),
        costmap(parameters.costmap, footprint) {}

  /// Whether the base cannot have driven to `T_odom_base` since the last scan: odometry has been reset.
  bool hasJumped(const Pose2& T_odom_base, Time stamp) const {
    if (!last) return false;
    const double seconds = std::clamp(toSeconds(stamp - last->stamp), 0.0, kLongestGap);
    return isJump(last->pose, T_odom_base, kJump + limits.max_linear * seconds,
                  kAngleJump + limits.max_angular * seconds);
  }

  Outline footprint;
  RobotLimits limits;
  LocalCostmapParameters window;  ///< its least side
  LocalCostmap costmap;
  std::optional<StampedPose2> last;  ///< where the last scan was inserted
};

CollisionCheck::CollisionCheck(const CollisionCheckParameters& parameters, const RobotModel& robot)
    : impl_(std::make_unique<Impl>(parameters, robot)) {}
CollisionCheck::~CollisionCheck() = default;
CollisionCheck::CollisionCheck(CollisionCheck&&) noexcept = default;
CollisionCheck& CollisionCheck::operator=(CollisionCheck&&) noexcept = default;

bool CollisionCheck::insert(const LaserScan2& scan, const Pose2& T_odom_base) {
  if (!looksAhead(scan)) return false;
  if (impl_->hasJumped(T_odom_base, scan.stamp)) clear();
  impl_->costmap.insert(scan, T_odom_base);
  impl_->last = StampedPose2{scan.stamp, T_odom_base};
  return true;
}

void CollisionCheck::setReach(double reach) {
  const LocalCostmapParameters& window = impl_->window;
  // The robot is anywhere in the cell in the middle.
  const double needed = 2.0 * (reach + impl_->footprint.circumscribedRadius() + window.resolution);
  impl_->costmap.setSide(std::max(window.side, std::min(needed, LocalCostmapParameters::kMostSide)));
}

void CollisionCheck::clear() {
  impl_->costmap.clear();
  impl_->last.reset();
}

const OccupancyGrid& CollisionCheck::grid() const { return impl_->costmap.grid(); }

const Outline& CollisionCheck::footprint() const { return impl_->footprint; }

LookAhead CollisionCheck::lookAhead(double max_age, Time now) const {
  const auto stamp = impl_->costmap.stamp();
  if (!stamp || std::abs(toSeconds(now - *stamp)) > max_age) return {};
  return [impl = impl_.get()](const Pose2& T_odom_base, const AxisMotion& motion) {
    return sweep(impl->costmap.grid(), impl->footprint, T_odom_base, motion);
  };
}

}  // namespace frontier_pilot::behavior
