#include "examples.h"

#include "frontier_pilot/patrol/patrol.h"

namespace fp = frontier_pilot;

bool examples::patrol() {
  //! [example]
  fp::patrol::Patrol patrol{fp::patrol::PatrolParameters()};
  fp::MotionSample odometry;
  fp::patrol::PatrolOutput output = patrol.start({1.0, 0.5, 1.0}, odometry.stamp);  // a square of 0.5 m, one lap
  while (patrol.active()) {
    fp::patrol::PatrolInputs inputs;
    inputs.odometry = odometry;
    output = patrol.update(inputs, odometry.stamp);
    odometry.twist = output.command.value_or(fp::Twist2());
    odometry.T_odom_base = fp::integrate(odometry.T_odom_base, odometry.twist, 0.05);  // the base does what it is told
    odometry.stamp += std::chrono::milliseconds(50);
  }
  return output.outcome == fp::patrol::PatrolOutcome::kCompleted && odometry.T_odom_base.position().norm() < 0.05;
  //! [example]
}
