#include "examples.h"

#include <cmath>

#include "frontier_pilot/slam/graph_slam.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::slam() {
  //! [example]
  const fp::Pose2 truth(0.06, -0.01, 0.03);
  const fp::Pose2 T_odom_base(0.05, 0.0, 0.02);  // a little wrong, as odometry is
  const fp::occupancy::OccupancyMap map;         // the caller's, which the revisions replace
  fp::slam::GraphSlam slam;
  slam.correct(fp::surfaces::readScan(scanFrom({}, fp::timeFromSeconds(10.0))), {}, map);
  const fp::surfaces::SurfaceScan scan = fp::surfaces::readScan(scanFrom(truth, fp::timeFromSeconds(10.1)));
  const auto corrected = slam.correct(scan, T_odom_base, map);
  if (const fp::slam::RevisionWork work = slam.takeWork()) slam.accept(work());  // `work` may run on another thread
  const fp::Pose2 T_map_base = corrected.T_map_odom * T_odom_base;
  const bool near = (T_map_base.position() - truth.position()).norm() < 0.01;
  return corrected.fits_map && near && std::abs(T_map_base.yaw - truth.yaw) < 0.005;
  //! [example]
}
