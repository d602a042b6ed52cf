#include "ros/mapper/mapper_parameters.h"

namespace frontier_pilot {

void MapperNodeParameters::check(Problems& problems) const {
  if (autosave_period > 0.0 && autosave_period < 0.1) problems.emplace_back("autosave_period: must be 0 or >= 0.1");
  const std::string& odom = mapper.robot.odomFrameOr(odom_frame);
  if (map_frame == odom) problems.push_back("map_frame: is the frame of odometry as well, '" + map_frame + "'");
  mapper.robot.checkIsNotBase(problems, "map_frame", map_frame, base_frame);
  const bool are_the_robots = odom_frame.empty() && base_frame.empty();  // which are checked as the robot's
  if (!are_the_robots) mapper.robot.checkIsNotBase(problems, "odom_frame", odom, base_frame);
}

}  // namespace frontier_pilot
