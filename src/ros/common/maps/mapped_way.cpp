#include "ros/common/maps/mapped_way.h"

#include <chrono>

namespace frontier_pilot {
namespace {

constexpr double kStep = 0.1;           // [m]
constexpr std::uint64_t kFewSteps = 1;  // the one in which the map was saved
constexpr Duration kJustSaved = std::chrono::seconds(10);

}  // namespace

void MappedWay::note(const Vec2& place) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (begun_ && (place - *begun_).norm() < kStep) return;
  if (begun_) ++steps_;
  begun_ = place;
}

std::uint64_t MappedWay::steps() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return steps_;
}

void MappedWay::noteSaved(std::uint64_t steps, SteadyTime at) {
  const std::lock_guard<std::mutex> lock(mutex_);
  saved_ = Saved{steps, at};
}

bool MappedWay::wasSaved() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return saved_.has_value();
}

bool MappedWay::hasGoneOn(SteadyTime now) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return saved_ && steps_ - saved_->steps > kFewSteps && now - saved_->at > kJustSaved;
}

}  // namespace frontier_pilot
