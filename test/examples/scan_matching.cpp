#include "examples.h"

#include <cmath>

#include "frontier_pilot/scan_matching/correlative_search.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::scanMatching() {
  //! [example]
  const fp::Pose2 truth(0.06, -0.04, 0.03);
  fp::scan_matching::SurfaceMap map;
  map.add(fp::surfaces::filled(fp::surfaces::readScan(scanFrom({})).points), {});
  const auto points = fp::surfaces::thinned(fp::surfaces::readScan(scanFrom(truth)).points);
  fp::scan_matching::SearchRequest request;
  request.window = {0.2, 0.2, 0.2};
  const fp::scan_matching::MaxPyramid pyramid(map.field(), 3);
  const auto found = fp::scan_matching::correlativeSearch(pyramid, points, request);  // to a cell
  if (!found) return false;
  const auto refined = fp::scan_matching::refine(map, points, found->pose, std::nullopt, {});  // and finer
  return (refined.pose.position() - truth.position()).norm() < 0.01 && std::abs(refined.pose.yaw - truth.yaw) < 0.005;
  //! [example]
}
