#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// A polygon that grows click by click, until a click near its first corner closes it. Positions in the map's frame
/// [m]; times are steady. [EXP-10]
class ClickedPolygon {
 public:
  enum class Click {
    kCorner,   ///< added as a corner
    kSame,     ///< at the last corner, as by a double click: nothing is added
    kClosed,   ///< near the first of at least three corners: the polygon is complete
    kTooMany,  ///< not added: the bounds cannot have more corners
  };

  Click add(const Vec2& at, SteadyTime now);
  /// Whether corners were dropped because the last click is too long ago.
  bool expire(SteadyTime now);
  void clear() { corners_.clear(); }
  const std::vector<Vec2>& corners() const { return corners_; }

  static constexpr double kCloseDistance = 0.5;  ///< of a click that closes it from the first corner [m]
  static constexpr Duration kPatience = std::chrono::seconds(30);

 private:
  std::vector<Vec2> corners_;
  SteadyTime last_click_{};
};

}  // namespace frontier_pilot
