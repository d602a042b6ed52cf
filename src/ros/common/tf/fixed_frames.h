#pragma once

#include <geometry_msgs/TransformStamped.h>

#include <map>
#include <string>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Which frames are fixed to their parents and which move, so that a message of another node can neither turn the
/// scanner nor nail the robot to the floor: the first static transform of a frame holds, also against one that is not
/// static (tf2 would replace it), and a frame that moves does not become fixed.
///
/// A latched transform that somebody has left behind may be heard before the true one. So a frame that is said to be
/// elsewhere, or under another parent, soon after its first static transform is disputed: nothing is known of it until
/// the node is restarted, and a robot that needs it stands. [FLT-1]
class FixedFrames {
 public:
  /// What speaks against taking over this transform, whose numbers are valid; empty if nothing does, and then it is
  /// remembered. A frame moves if a transform of it that is not static was taken over in the last 5 s; after twenty of
  /// them it moves for good, so that a pause is no occasion to fix it.
  std::string objection(const geometry_msgs::TransformStamped& transform, bool is_static, SteadyTime now);
  /// The frame that has become disputed by the last objection; empty if none has.
  std::string takeDisputed();

 private:
  struct Fixed {
    geometry_msgs::TransformStamped transform;
    SteadyTime since;
    int moving = 0;  ///< transforms that are not static and say otherwise
    bool disputed = false;
  };
  std::string objectionOfFixed(Fixed& fixed, const geometry_msgs::TransformStamped& transform, bool is_static,
                               SteadyTime now);

  std::map<std::string, Fixed> fixed_;  ///< by child
  std::string disputed_;                ///< by the last objection
  struct Motion {
    SteadyTime last;
    int heard = 0;
  };
  static bool moves(const Motion& motion, SteadyTime now);

  std::map<std::string, Motion> moved_;  ///< by child
};

}  // namespace frontier_pilot
