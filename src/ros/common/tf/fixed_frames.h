#pragma once

#include <geometry_msgs/TransformStamped.h>

#include <map>
#include <string>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// The frame without a leading slash: to tf2 "/base" and "base" are the same frame.
std::string plain(const std::string& frame);

/// Which frames are fixed to their parents and which move, so that a message of another node can neither turn the
/// scanner nor nail the robot to the floor: the first static transform of a frame holds, also against one that is not
/// static (tf2 would replace it), and a frame that moves does not become fixed. [FLT-1]
class FixedFrames {
 public:
  /// What speaks against taking over this transform, whose numbers are valid; empty if nothing does, and then it is
  /// remembered. A frame moves if a transform of it that is not static was taken over in the last 5 s.
  std::string objection(const geometry_msgs::TransformStamped& transform, bool is_static, SteadyTime now);

 private:
  std::map<std::string, geometry_msgs::TransformStamped> fixed_;  ///< by child
  std::map<std::string, SteadyTime> moved_;                       ///< by child: when it was heard last
};

}  // namespace frontier_pilot
