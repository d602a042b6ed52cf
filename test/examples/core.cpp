#include "examples.h"

#include "frontier_pilot/core/robot_model.h"

namespace fp = frontier_pilot;

bool examples::core() {
  //! [example]
  fp::RobotModel robot;
  const fp::Problems problems = fp::loadParameters(fp::parseYaml("{disc_radius: 0.2, wheels: 2}"), robot);
  const bool one_is_told = problems.size() == 1;  // there is no parameter `wheels`; all others have been read
  const fp::Pose2 T_map_base(1.0, 2.0, fp::kPi / 2.0);
  const fp::Vec2 front = T_map_base * fp::Vec2(robot.drivenOutline().front(), 0.0);  // in the map's frame
  return one_is_told && (front - fp::Vec2(1.0, 2.2)).norm() < 1e-9;
  //! [example]
}
