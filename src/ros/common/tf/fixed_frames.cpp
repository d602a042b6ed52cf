#include "ros/common/tf/fixed_frames.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/tf/frame_name.h"

namespace frontier_pilot {
namespace {

constexpr Duration kMoves = std::chrono::seconds(5);
constexpr int kEnough = 20;  ///< transforms that make it certain that a frame moves
/// For all nodes of a launch to begin, after the first static transform of a frame.
constexpr Duration kSettles = std::chrono::seconds(10);

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
  disputed_.clear();
  const auto fixed = fixed_.find(child);
  if (fixed != fixed_.end()) return objectionOfFixed(fixed->second, transform, is_static, now);
  const auto moved = moved_.find(child);
  if (is_static && moved != moved_.end() && moves(moved->second, now)) {
    return "'" + child + "' moves, so a static transform of it cannot be right: restart the nodes if it is fixed now";
  }
  const bool room = fixed_.size() + moved_.size() < 2 * bounds::kMostFrames;
  if (is_static && room) fixed_.emplace(child, Fixed{transform, now});
  if (!is_static && (room || moved != moved_.end())) {
    Motion& motion = moved_[child];
    motion.last = now;
    motion.heard = std::min(motion.heard + 1, kEnough);
  }
  return {};
}

std::string FixedFrames::objectionOfFixed(Fixed& fixed, const geometry_msgs::TransformStamped& transform,
                                          bool is_static, SteadyTime now) {
  const std::string child = plain(transform.child_frame_id);
  const bool same_parent = plain(fixed.transform.header.frame_id) == plain(transform.header.frame_id);
  const bool same = same_parent && areSame(fixed.transform, transform);
  const bool settles = now - fixed.since < kSettles || fixed.moving > 0;
  if (!same && !fixed.disputed && settles) {
    if (!is_static) ++fixed.moving;
    fixed.disputed = is_static || fixed.moving >= kEnough;
    if (fixed.disputed) disputed_ = child;
  }
  if (fixed.disputed)
    return "'" + child +
           "' is said to be in two places, one of them by a static transform: end the node that is wrong, and restart "
           "this one";
  return same ? "" : "'" + child + "' has another static transform: restart the nodes if it has been moved";
}

std::string FixedFrames::takeDisputed() { return std::exchange(disputed_, {}); }

}  // namespace frontier_pilot
