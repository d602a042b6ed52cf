#include "examples.h"

#include <cmath>

#include "frontier_pilot/grids/distance_field.h"
#include "frontier_pilot/grids/ray_casting.h"

namespace fp = frontier_pilot;

bool examples::grids() {
  //! [example]
  fp::GridGeometry geometry;
  geometry.resolution = 0.1;
  geometry.width = geometry.height = 50;
  fp::Grid<std::uint8_t> solid(geometry, 0);
  for (int y = 0; y < geometry.height; ++y) solid[fp::Cell{40, y}] = 1;  // a wall whose surface is at x = 4 m
  const fp::Vec2 point(1.05, 2.55);
  const double range = fp::grids::RayCaster(solid).cast(point, 0.0, 10.0);  // to the surface
  const double distance =
      fp::grids::DistanceField(solid, 2.0).at(fp::Vec2(3.05, 2.55));  // from cell to cell, 2 m at most
  return std::abs(range - 2.95) < 1e-6 && std::abs(distance - 1.0) < 1e-6;
  //! [example]
}
