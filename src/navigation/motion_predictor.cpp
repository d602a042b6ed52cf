#include "navigation/motion_predictor.h"

#include <algorithm>

namespace frontier_pilot::navigation {
namespace {

constexpr Duration kMemory = std::chrono::seconds(1);
constexpr Duration kPredictionStep = std::chrono::milliseconds(20);

}  // namespace

void MotionPredictor::commanded(const Twist2& command, Time now) {
  if (!commands_.empty() && now < commands_.back().since) commands_.clear();
  commands_.push_back({now, command});
  while (now - commands_.front().since > kMemory) commands_.pop_front();
}

const Twist2* MotionPredictor::commandAt(Time time) const {
  const auto in_force = std::find_if(commands_.rbegin(), commands_.rend(),
                                     [time](const Command& command) { return command.since <= time; });
  return in_force == commands_.rend() ? nullptr : &in_force->twist;
}

MotionPredictor::Motion MotionPredictor::predict(const StampedPose2& pose, const Twist2& twist, Time now) const {
  Motion motion{pose.pose, twist};
  for (Time time = pose.stamp; time < now; time += kPredictionStep) {
    const double seconds = toSeconds(std::min(kPredictionStep, Duration(now - time)));
    if (const Twist2* command = commandAt(time)) {
      motion.twist = limitAcceleration(*command, motion.twist, limits_, seconds);
    }
    motion.T_map_base = integrate(motion.T_map_base, motion.twist, seconds);
  }
  return motion;
}

}  // namespace frontier_pilot::navigation
