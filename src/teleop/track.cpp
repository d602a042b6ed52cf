#include "teleop/track.h"

namespace frontier_pilot::teleop {

Track::Track(double spacing, std::size_t most) : first_spacing_(spacing), spacing_(spacing), most_(most) {}

void Track::add(const Vec2& position) {
  if (!position.allFinite()) return;
  if (!points_.empty() && (position - points_.back()).norm() < spacing_) return;
  points_.push_back(position);
  if (points_.size() <= most_) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points_.size(); i += 2) points_[kept++] = points_[i];
  points_.resize(kept);
  spacing_ *= 2.0;
}

void Track::clear() {
  points_.clear();
  spacing_ = first_spacing_;
}

}  // namespace frontier_pilot::teleop
