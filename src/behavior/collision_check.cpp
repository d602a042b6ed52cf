#include "frontier_pilot/behavior/collision_check.h"

#include <cmath>

#include "behavior/local_costmap.h"
#include "behavior/sweep.h"

namespace frontier_pilot::behavior {

struct CollisionCheck::Impl {
  Impl(const CollisionCheckParameters& parameters, const RobotModel& robot)
      : footprint(robot.exactOutline().padded(parameters.footprint.padding)), costmap(parameters.costmap, footprint) {}

  Outline footprint;
  LocalCostmap costmap;
};

CollisionCheck::CollisionCheck(const CollisionCheckParameters& parameters, const RobotModel& robot)
    : impl_(std::make_unique<Impl>(parameters, robot)) {}
CollisionCheck::~CollisionCheck() = default;
CollisionCheck::CollisionCheck(CollisionCheck&&) noexcept = default;
CollisionCheck& CollisionCheck::operator=(CollisionCheck&&) noexcept = default;

bool CollisionCheck::insert(const LaserScan2& scan, const Pose2& T_odom_base) {
  if (!looksAhead(scan)) return false;
  impl_->costmap.insert(scan, T_odom_base);
  return true;
}

void CollisionCheck::clear() { impl_->costmap.clear(); }

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
