#include "examples.h"

#include "frontier_pilot/surfaces/surface_points.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::surfaces() {
  //! [example]
  const fp::surfaces::SurfacePoints surface = fp::surfaces::readScan(scanFrom({})).points;
  const fp::surfaces::SurfacePoint& left = surface[90];  // of the beam that points to the left
  const bool looks_back = left.position.y() > 1.99 && left.normal.y() < -0.99;
  const fp::surfaces::SurfacePoints to_match = fp::surfaces::thinned(surface);  // few points, evenly spaced
  const fp::surfaces::SurfacePoints to_map = fp::surfaces::filled(surface);     // the wall between the beams as well
  return looks_back && to_match.size() < surface.size() && to_map.size() > surface.size();
  //! [example]
}
