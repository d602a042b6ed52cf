#include <algorithm>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/motion.h"

namespace frontier_pilot {

void PoseTrack::add(Time stamp, const Pose2& pose) {
  if (!poses_.empty() && stamp == poses_.back().stamp) return;
  if (!poses_.empty() && stamp < poses_.back().stamp) poses_.clear();
  poses_.push_back({stamp, pose});
  // Limited in number as well: stamps may be only nanoseconds apart. [FLT-1]
  while (stamp - poses_.front().stamp > kept_ || poses_.size() > bounds::kMostOdometry) poses_.pop_front();
}

std::deque<StampedPose2>::const_iterator PoseTrack::notBefore(Time stamp) const {
  return std::lower_bound(poses_.begin(), poses_.end(), stamp,
                          [](const StampedPose2& entry, Time time) { return entry.stamp < time; });
}

std::optional<Pose2> PoseTrack::nearest(Time stamp) const {
  if (poses_.empty()) return std::nullopt;
  const auto after = notBefore(stamp);
  if (after == poses_.end()) return poses_.back().pose;
  if (after == poses_.begin() || after->stamp == stamp) return after->pose;
  const auto before = std::prev(after);
  return interpolate(before->pose, after->pose,
                     toSeconds(stamp - before->stamp) / toSeconds(after->stamp - before->stamp));
}

Duration PoseTrack::away(Time stamp, Duration gap) const {
  if (poses_.empty()) return Duration::max();
  const auto after = notBefore(stamp);
  if (after == poses_.end()) return stamp - poses_.back().stamp;
  if (after == poses_.begin()) return after->stamp - stamp;
  const auto before = std::prev(after);
  if (after->stamp - before->stamp < gap) return Duration::zero();
  return std::min(after->stamp - stamp, stamp - before->stamp);
}

}  // namespace frontier_pilot
