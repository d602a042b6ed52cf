#include <algorithm>

#include "exploration/explorer_impl.h"
#include "exploration/progress/whole_estimate.h"

namespace frontier_pilot::exploration {

/// A step that is larger than the robot can have driven is a correction of the pose, not motion.
void Explorer::Impl::trackMotion(const ExplorerInputs& inputs, Time now) {
  constexpr double kJump = 1.0;  // [m] beyond what the robot can have driven
  if (!inputs.T_map_base || !inputs.T_map_base->pose.isFinite()) return;
  const Pose2& pose = inputs.T_map_base->pose;
  const double moved = T_map_base_ ? (pose.position() - T_map_base_->position()).norm() : 0.0;
  const double driven = parameters_.robot.limits.max_linear * toSeconds(sinceLastTick(now));
  if (moved < driven + kJump) status_.distance_travelled += moved;
  T_map_base_ = pose;
  constexpr double kDrives = 0.1;  // [m]: more than the pose of a robot that stands wanders
  if (unable_at_ && (pose.position() - *unable_at_).norm() >= kDrives) unable_at_.reset();
}

/// What has passed by the clock, but for its jumps.
Duration Explorer::Impl::sinceLastTick(Time now) const {
  const Duration passed = last_update_ ? now - *last_update_ : Duration::zero();
  return passed > Duration::zero() && passed < kLongestTick ? passed : Duration::zero();
}

void Explorer::Impl::countFrontiers() {
  status_.frontiers_found = static_cast<std::uint32_t>(evaluator_.frontiers().size());
  status_.frontiers_selectable = static_cast<std::uint32_t>(countRejected(Rejection::kNone));
  status_.frontiers_blacklisted = static_cast<std::uint32_t>(countRejected(Rejection::kBlacklisted));
  status_.explored_area = evaluator_.map().freeArea();
  status_.inspected = inspections_.doneCount();
  status_.inspections_failed = inspections_.givenUpCount();
  status_.explored_before = rules_.areaBefore();
  status_.exploring_time = rules_.time();
  status_.exploring_distance = rules_.distance();
}

/// By the decision that has just been made for a goal. [EXP-12]
void Explorer::Impl::estimateWhole() {
  ExplorationRecord record;
  record.explored_area = evaluator_.map().freeArea();
  record.explored_before = rules_.areaBefore();
  record.time = rules_.time();
  record.distance = rules_.distance();
  for (const Frontier& frontier : evaluator_.frontiers()) {
    if (frontier.selectable()) record.area_in_sight += frontier.info.area;
  }
  for (std::size_t i = 1; i < chosen_.tour.size(); ++i) {
    record.tour_length += (chosen_.tour[i] - chosen_.tour[i - 1]).norm();
  }
  const auto whole = exploration::estimateWhole(record);
  if (whole) status_.whole = whole;
}

/// Nothing is left that could be reached: what is explored is the whole, of which nothing has to be estimated.
void Explorer::Impl::setWholeExplored() {
  const double area = evaluator_.map().freeArea();
  if (status_.whole) status_.whole = WholeEstimate{area, 0.0, 0.0, area};
}

std::size_t Explorer::Impl::countRejected(Rejection rejection) const {
  const auto& all = evaluator_.frontiers();
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [&](const Frontier& f) { return f.rejection == rejection; }));
}

}  // namespace frontier_pilot::exploration
