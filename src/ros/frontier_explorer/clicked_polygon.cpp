#include "ros/frontier_explorer/clicked_polygon.h"

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot {

ClickedPolygon::Click ClickedPolygon::add(const Vec2& at, SteadyTime now) {
  constexpr double kDoubleClick = 0.05;  // [m]
  expire(now);
  last_click_ = now;
  if (!corners_.empty() && (at - corners_.back()).norm() < kDoubleClick) return Click::kSame;
  if (corners_.size() >= 3 && (at - corners_.front()).norm() <= kCloseDistance) return Click::kClosed;
  if (corners_.size() >= bounds::kMostBoundsCorners) return Click::kTooMany;
  corners_.push_back(at);
  return Click::kCorner;
}

bool ClickedPolygon::expire(SteadyTime now) {
  if (corners_.empty() || now - last_click_ < kPatience) return false;
  corners_.clear();
  return true;
}

}  // namespace frontier_pilot
