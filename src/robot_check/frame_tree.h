#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robot_check/observation.h"

namespace frontier_pilot::robot_check {

/// All frames that a transform names.
std::set<std::string> framesOf(const std::vector<FrameLink>& links);

/// The transforms from `frame` up to its root, beginning with the one whose child it is. A frame with two parents
/// follows the first of them.
std::vector<const FrameLink*> wayUp(const std::vector<FrameLink>& links, const std::string& frame);

/// `T_target_source`; nothing if the two frames are not connected.
std::optional<Eigen::Isometry3d> transformBetween(const std::vector<FrameLink>& links, const std::string& target,
                                                  const std::string& source);

}  // namespace frontier_pilot::robot_check
