#include "frontier_pilot/planning/recovery.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "frontier_pilot/core/motion.h"

namespace frontier_pilot {
namespace {

/// How far ahead in time the way back is looked at [s].
constexpr double kLookBehind = 1.0;

/// Whether the footprint can go `distance` [m] backwards from `pose`, or at least gets no nearer to anything.
bool isFreeBehind(const RecoveryParams& params, const RecoveryInputs& in, double distance) {
  const double now = in.scan.distance(in.T_map_base.position());
  const Vec2 backwards = -direction(in.T_map_base.yaw);
  for (double s = 0.02; s <= distance + 1e-9; s += 0.02) {
    const double there = in.scan.distance(in.T_map_base.position() + s * backwards);
    if (there < params.footprint_radius && there < now) return false;
  }
  return true;
}

}  // namespace

Recovery backUp(const RecoveryParams& params, const RobotLimits& limits) {
  const double speed = std::min(params.back_up_speed, limits.max_linear);
  return [=, begun = std::optional<Time>(), from = Vec2(Vec2::Zero())](const RecoveryInputs& in, Time now) mutable {
    if (!begun) {
      begun = now;
      from = in.T_map_base.position();
    }
    const double done = (in.T_map_base.position() - from).norm();
    const bool late = toSeconds(now - *begun) > params.time_allowance;
    if (late || done >= params.back_up_distance || !isFreeBehind(params, in, speed * kLookBehind)) {
      return RecoveryStep{{}, true};
    }
    return RecoveryStep{{-speed, 0.0}, false};
  };
}

Recovery spin(const RecoveryParams& params, const RobotLimits& limits) {
  const double rate = std::min(params.spin_rate, limits.max_angular);
  return [=, begun = std::optional<Time>(), turned = TurnCounter()](const RecoveryInputs& in, Time now) mutable {
    if (!begun) {
      begun = now;
      turned.restart(in.T_map_base.yaw);
    }
    const bool late = toSeconds(now - *begun) > params.time_allowance;
    if (late || turned.add(in.T_map_base.yaw) >= params.spin_angle) return RecoveryStep{{}, true};
    return RecoveryStep{{0.0, rate}, false};
  };
}

std::vector<RecoveryRung> defaultLadder(const RecoveryParams& params, const RobotLimits& limits) {
  return {{"clearing the local costmap", true, {}},
          {"backing up", false, [=] { return backUp(params, limits); }},
          {"spinning", true, [=] { return spin(params, limits); }}};
}

}  // namespace frontier_pilot
