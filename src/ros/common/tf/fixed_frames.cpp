#include "ros/common/tf/fixed_frames.h"

#include "frontier_pilot/core/bounds.h"
#include "ros/common/messages/conversions.h"

namespace frontier_pilot {
namespace {

constexpr Duration kMoves = std::chrono::seconds(5);

bool areSame(const geometry_msgs::TransformStamped& a, const geometry_msgs::TransformStamped& b) {
  constexpr double kSame = 1e-3;  // greatest difference of an entry of the matrices: [m], and about [rad]
  const auto before = toIsometry(a.transform), now = toIsometry(b.transform);
  return before && now && (before->matrix() - now->matrix()).cwiseAbs().maxCoeff() <= kSame;
}

}  // namespace

std::string plain(const std::string& frame) { return !frame.empty() && frame.front() == '/' ? frame.substr(1) : frame; }

std::string FixedFrames::objection(const geometry_msgs::TransformStamped& transform, bool is_static, SteadyTime now) {
  const std::string child = plain(transform.child_frame_id);
  const auto fixed = fixed_.find(child);
  if (fixed != fixed_.end()) {
    const bool same_parent = plain(fixed->second.header.frame_id) == plain(transform.header.frame_id);
    if (same_parent && areSame(fixed->second, transform)) return {};
    return "'" + child + "' has another static transform: restart the nodes if it has been moved";
  }
  const auto moved = moved_.find(child);
  if (is_static && moved != moved_.end() && now - moved->second < kMoves) {
    return "'" + child + "' moves, so a static transform of it cannot be right";
  }
  const bool room = fixed_.size() + moved_.size() < 2 * bounds::kMostFrames;
  if (is_static && room) fixed_.emplace(child, transform);
  if (!is_static && (room || moved != moved_.end())) moved_[child] = now;
  return {};
}

}  // namespace frontier_pilot
