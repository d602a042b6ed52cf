#include "ros/mapper/mapper_parameters.h"

namespace frontier_pilot {

void MapperNodeParameters::check(Problems& problems) const {
  if (autosave_period > 0.0 && autosave_period < 0.1) problems.emplace_back("autosave_period: must be 0 or >= 0.1");
  const std::string& odom = mapper.robot.odomFrameOr(odom_frame);
  const std::string& base = mapper.robot.baseFrameOr(base_frame);
  if (map_frame == odom || map_frame == base)
    problems.push_back("map_frame: is the frame of odometry or of the robot as well, '" + map_frame + "'");
  const bool are_the_robots = odom_frame.empty() && base_frame.empty();  // which are checked as the robot's
  if (odom == base && !are_the_robots)
    problems.push_back("base_frame: is the frame of odometry as well, '" + base + "'");
}

}  // namespace frontier_pilot
