#pragma once

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::bench {

/// Centimetres as whole cells of 5 cm.
constexpr int cm(int centimetres) { return centimetres / 5; }

/// The sides of a rectangle; y points north.
enum class Side { kSouth, kNorth, kWest, kEast };
constexpr Side opposite(Side side) {
  switch (side) {
    case Side::kSouth:
      return Side::kNorth;
    case Side::kNorth:
      return Side::kSouth;
    case Side::kWest:
      return Side::kEast;
    case Side::kEast:
      break;
  }
  return Side::kWest;
}

/// A rectangle of cells as seen from one of its walls: x runs along the wall, y from the wall into the room.
class WallFrame {
 public:
  WallFrame(const CellRect& area, Side wall) : area_(area), wall_(wall) {}

  int length() const { return alongX() ? area_.width : area_.height; }
  int depth() const { return alongX() ? area_.height : area_.width; }
  /// The cells of a block given in this frame. It may extend beyond the area, also to negative coordinates.
  CellRect cells(const CellRect& local) const {
    const int far = depth() - local.y - local.height;
    switch (wall_) {
      case Side::kSouth:
        return {area_.x + local.x, area_.y + local.y, local.width, local.height};
      case Side::kNorth:
        return {area_.x + local.x, area_.y + far, local.width, local.height};
      case Side::kWest:
        return {area_.x + local.y, area_.y + local.x, local.height, local.width};
      case Side::kEast:
        break;
    }
    return {area_.x + far, area_.y + local.x, local.height, local.width};
  }

 private:
  bool alongX() const { return wall_ == Side::kSouth || wall_ == Side::kNorth; }

  CellRect area_;
  Side wall_;
};

}  // namespace frontier_pilot::bench
