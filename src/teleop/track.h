#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::teleop {

/// Where the robot has been, as points at least `spacing` [m] apart. When there are more than `most`, every second one
/// is dropped and the spacing doubles: a long run keeps its shape, and memory is bounded. [FLT-1]
class Track {
 public:
  explicit Track(double spacing = 0.05, std::size_t most = 4000);

  /// Adds the position unless it is too near to the last point, or not finite.
  void add(const Vec2& position);
  void clear();
  const std::vector<Vec2>& points() const { return points_; }

 private:
  double first_spacing_, spacing_;
  std::size_t most_;
  std::vector<Vec2> points_;
};

}  // namespace frontier_pilot::teleop
