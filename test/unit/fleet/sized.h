#pragma once

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::test {

/// A geometry of that many cells with its lower left corner at `origin` [m].
inline GridGeometry sized(int width, int height, const Vec2& origin = Vec2::Zero()) {
  GridGeometry geometry;
  geometry.width = width;
  geometry.height = height;
  geometry.origin = origin;
  return geometry;
}

}  // namespace frontier_pilot::test
