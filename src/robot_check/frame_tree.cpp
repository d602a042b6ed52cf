#include "robot_check/frame_tree.h"

#include <algorithm>
#include <map>

namespace frontier_pilot::robot_check {
namespace {

/// The poses of `frame` in itself and in all frames above it.
std::map<std::string, Eigen::Isometry3d> posesAbove(const std::vector<FrameLink>& links, const std::string& frame) {
  std::map<std::string, Eigen::Isometry3d> poses = {{frame, Eigen::Isometry3d::Identity()}};
  Eigen::Isometry3d T_above_frame = Eigen::Isometry3d::Identity();
  for (const FrameLink* link : wayUp(links, frame)) {
    T_above_frame = link->T_parent_child * T_above_frame;
    poses.emplace(link->parent, T_above_frame);
  }
  return poses;
}

}  // namespace

std::set<std::string> framesOf(const std::vector<FrameLink>& links) {
  std::set<std::string> frames;
  for (const FrameLink& link : links) {
    frames.insert(link.parent);
    frames.insert(link.child);
  }
  return frames;
}

std::vector<const FrameLink*> wayUp(const std::vector<FrameLink>& links, const std::string& frame) {
  std::vector<const FrameLink*> way;
  std::string at = frame;
  while (way.size() <= links.size()) {  // transforms in a circle do not end
    const auto up = std::find_if(links.begin(), links.end(), [&](const FrameLink& link) { return link.child == at; });
    if (up == links.end()) break;
    way.push_back(&*up);
    at = up->parent;
  }
  return way;
}

std::optional<Eigen::Isometry3d> transformBetween(const std::vector<FrameLink>& links, const std::string& target,
                                                  const std::string& source) {
  const std::set<std::string> frames = framesOf(links);
  if (target != source && (frames.count(target) == 0 || frames.count(source) == 0)) return std::nullopt;
  const auto of_target = posesAbove(links, target);
  for (const auto& [frame, T_frame_source] : posesAbove(links, source)) {
    const auto common = of_target.find(frame);
    if (common != of_target.end()) return common->second.inverse() * T_frame_source;
  }
  return std::nullopt;
}

}  // namespace frontier_pilot::robot_check
