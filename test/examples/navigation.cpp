#include "examples.h"

#include "frontier_pilot/navigation/navigator.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::navigation() {
  //! [example]
  const fp::OccupancyGrid map = roomMap();
  fp::navigation::Navigator navigator;
  navigator.setMap(map, map.geometry().rect());
  fp::Pose2 pose(-2.0, 0.0, 0.0);
  fp::navigation::NavigatorInputs inputs;
  fp::navigation::NavigatorOutput output;
  inputs.new_goal = fp::navigation::NavGoal{1, fp::Pose2(2.0, 0.5, 0.0), false};
  for (fp::Time now; output.finished.empty() && fp::toSeconds(now) < 60.0; now += std::chrono::milliseconds(50)) {
    const fp::LaserScan2 scan = scanFrom(pose, now);
    inputs.scan = &scan;
    inputs.pose = fp::StampedPose2{now, pose};
    output = navigator.update(inputs, now);
    inputs.new_goal.reset();  // it is an event
    inputs.twist = output.command.value_or(fp::Twist2());
    pose = fp::integrate(pose, inputs.twist, 0.05);  // the base does what it is told
  }
  return !output.finished.empty() && output.finished.front().result == fp::navigation::NavResult::kSucceeded;
  //! [example]
}
