#include "examples.h"

#include <cmath>

#include "frontier_pilot/localization/map_localization.h"
#include "frontier_pilot/occupancy/scan_inserter.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::localization() {
  //! [example]
  const fp::Pose2 truth(0.3, -0.2, 0.1);
  fp::scan_matching::PoseWithCovariance about;  // where the robot is about: within 0.5 m and 0.25 rad of the origin
  about.covariance.diagonal() << 0.25, 0.25, 0.0625;
  fp::occupancy::OccupancyMap map;  // the known one, loaded or made before
  fp::occupancy::ScanInserter().insert(fp::surfaces::readScan(scanFrom({})), {}, map);
  using fp::localization::MapLocalization;
  MapLocalization localization(MapLocalization::Use::kLocalizeOnly, {}, map, {}, about);
  const fp::Pose2 T_odom_base;
  const fp::slam::CorrectedScan corrected =
      localization.correct(fp::surfaces::readScan(scanFrom(truth)), T_odom_base, map);
  const fp::Pose2 found = corrected.T_map_odom * T_odom_base;
  const bool near = (found.position() - truth.position()).norm() < 0.03 && std::abs(found.yaw - truth.yaw) < 0.02;
  return corrected.fits_map && near;
  //! [example]
}
