#include "examples.h"

#include <cmath>

#include "frontier_pilot/behavior/collision_check.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::behavior() {
  //! [example]
  fp::behavior::TimedBehavior behavior{fp::behavior::BehaviorParameters()};
  fp::behavior::CollisionCheck surroundings;
  fp::Pose2 pose;
  fp::Time now = fp::timeFromSeconds(10.0);
  auto output = behavior.start({fp::behavior::BehaviorKind::kSpin, fp::kPi / 2.0, 0.0, 10.0, true}, now);
  while (behavior.active()) {
    surroundings.insert(scanFrom(pose, now), pose);
    output = behavior.update({{{now, pose}}, surroundings.lookAhead(0.5, now)}, now);
    pose = fp::integrate(pose, output.command.value_or(fp::Twist2()), 0.1);  // the base does what it is told
    now += std::chrono::milliseconds(100);
  }
  return output.outcome == fp::behavior::BehaviorOutcome::kSucceeded && std::abs(pose.yaw - fp::kPi / 2.0) < 0.1;
  //! [example]
}
