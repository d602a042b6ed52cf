#pragma once

#include "support/drives/drive.h"

namespace frontier_pilot::test {

/// A place of 80 m x 80 m with two walled yards in opposite corners, some trees and poles, and a wall of 12 m; cells of
/// 10 cm. Most of it is more than 8 m from anything.
inline Grid<std::uint8_t> openPlace() {
  GridGeometry geometry;
  geometry.resolution = 0.1;
  geometry.width = 800;
  geometry.height = 800;
  Grid<std::uint8_t> solid(geometry, 0);
  // The yard where drives begin, open to the east.
  fill(solid, {60, 60, 100, 3}, 1);
  fill(solid, {60, 60, 3, 90}, 1);
  fill(solid, {60, 147, 80, 3}, 1);
  fill(solid, {75, 120, 12, 8}, 1);
  fill(solid, {120, 70, 6, 6}, 1);
  // The other one, open to the south-west.
  fill(solid, {640, 747, 110, 3}, 1);
  fill(solid, {747, 640, 3, 110}, 1);
  fill(solid, {690, 640, 57, 3}, 1);
  fill(solid, {660, 700, 10, 15}, 1);
  fill(solid, {720, 660, 6, 12}, 1);
  // Trees, poles and a wall.
  for (const Cell tree : {Cell{300, 250}, Cell{340, 300}, Cell{250, 380}, Cell{430, 360}, Cell{520, 540},
                          Cell{460, 600}, Cell{580, 480}, Cell{600, 300}, Cell{200, 600}, Cell{330, 520}}) {
    fill(solid, {tree.x, tree.y, 3, 3}, 1);
  }
  for (const Cell pole : {Cell{380, 420}, Cell{420, 420}, Cell{380, 460}}) fill(solid, {pole.x, pole.y, 1, 1}, 1);
  fill(solid, {560, 500, 120, 2}, 1);
  return solid;
}

}  // namespace frontier_pilot::test
