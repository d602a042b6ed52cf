#include "examples.h"

#include "frontier_pilot/mapping/mapper.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::mapping() {
  //! [example]
  fp::mapping::Mapper mapper;
  const fp::Time first = fp::timeFromSeconds(10.0);
  const fp::Time second = fp::timeFromSeconds(10.1);
  mapper.insert(scanFrom({}, first), fp::Pose2(), first);
  const fp::Pose2 T_odom_base(0.05, 0.0, 0.02);  // a little wrong, as odometry is
  const auto verdict = mapper.insert(scanFrom({0.06, -0.01, 0.03}, second), T_odom_base, second);
  mapper.reviseNow();  // or `takeWork` for another thread, and `revise`
  const fp::Pose2 T_map_base = mapper.T_map_odom() * T_odom_base;
  const bool corrected = (T_map_base.position() - fp::Vec2(0.06, -0.01)).norm() < 0.01;
  const fp::occupancy::MapChanges changes = mapper.takeChanges();  // what of `mapper.grid()` has to be published
  return verdict == fp::mapping::ScanVerdict::kInserted && corrected && !changes.empty();
  //! [example]
}
