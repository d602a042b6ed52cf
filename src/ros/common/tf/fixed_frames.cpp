#include "ros/common/tf/fixed_frames.h"

#include <algorithm>

#include "frontier_pilot/core/bounds.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/tf/frame_name.h"

namespace frontier_pilot {
namespace {

constexpr Duration kMoves = std::chrono::seconds(5);
constexpr int kEnough = 20;  ///< transforms that make it certain that a frame moves

bool areSame(const geometry_msgs::TransformStamped& a, const geometry_msgs::TransformStamped& b) {
  constexpr double kSame = 1e-3;  // greatest difference of an entry of the matrices: [m], and about [rad]
  const auto before = toIsometry(a.transform), now = toIsometry(b.transform);
  return before && now && (before->matrix() - now->matrix()).cwiseAbs().maxCoeff() <= kSame;
}

}  // namespace

bool FixedFrames::moves(const Motion& motion, SteadyTime now) {
  return motion.heard >= kEnough || now - motion.last < kMoves;
}

std::string FixedFrames::objection(const geometry_msgs::TransformStamped& transform, bool is_static, SteadyTime now) {
  const std::string child = plain(transform.child_frame_id);
  const auto fixed = fixed_.find(child);
  if (fixed != fixed_.end()) {
    const bool same_parent = plain(fixed->second.header.frame_id) == plain(transform.header.frame_id);
    if (same_parent && areSame(fixed->second, transform)) return {};
    return "'" + child + "' has another static transform: restart the nodes if it has been moved";
  }
  const auto moved = moved_.find(child);
  if (is_static && moved != moved_.end() && moves(moved->second, now)) {
    return "'" + child + "' moves, so a static transform of it cannot be right: restart the nodes if it is fixed now";
  }
  const bool room = fixed_.size() + moved_.size() < 2 * bounds::kMostFrames;
  if (is_static && room) fixed_.emplace(child, transform);
  if (!is_static && (room || moved != moved_.end())) {
    Motion& motion = moved_[child];
    motion.last = now;
    motion.heard = std::min(motion.heard + 1, kEnough);
  }
  return {};
}

}  // namespace frontier_pilot
