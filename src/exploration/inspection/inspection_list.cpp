#include "exploration/inspection/inspection_list.h"

#include <algorithm>

namespace frontier_pilot::exploration {

std::string InspectionList::add(const Pose2& pose) {
  constexpr double kSamePlace = 0.05;    // [m]
  constexpr double kSameHeading = 0.05;  // [rad]
  if (!pose.isFinite()) return "the pose has to be finite";
  const bool known = std::any_of(waiting_.begin(), waiting_.end(), [&](const Inspection& each) {
    return (each.pose.position() - pose.position()).norm() < kSamePlace &&
           std::abs(angleDifference(each.pose.yaw, pose.yaw)) < kSameHeading;
  });
  if (known) return "the pose waits to be inspected already";
  if (waiting_.size() >= kMost) return "no more than " + std::to_string(kMost) + " poses can wait to be inspected";
  waiting_.push_back({next_id_++, pose, 0});
  return {};
}

bool InspectionList::remove(std::uint32_t id) {
  const auto found =
      std::find_if(waiting_.begin(), waiting_.end(), [id](const Inspection& each) { return each.id == id; });
  if (found == waiting_.end()) return false;
  waiting_.erase(found);
  return true;
}

void InspectionList::done(std::uint32_t id) {
  if (remove(id)) ++done_;
}

bool InspectionList::failed(std::uint32_t id) {
  constexpr int kMostFailures = 1;
  for (Inspection& each : waiting_) {
    if (each.id == id && ++each.failures <= kMostFailures) return false;
  }
  if (!remove(id)) return false;
  ++given_up_;
  return true;
}

void InspectionList::giveUp() {
  given_up_ += static_cast<std::uint32_t>(waiting_.size());
  waiting_.clear();
}

}  // namespace frontier_pilot::exploration
