#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "ros/waypoint_follower/waypoint_problem.h"

namespace frontier_pilot {
namespace {

geometry_msgs::PoseStamped inFrame(const std::string& frame) {
  geometry_msgs::PoseStamped pose;
  pose.header.frame_id = frame;
  pose.pose.orientation.w = 1.0;
  return pose;
}

// [FLT-1]
TEST(ProblemOfWaypoint, IsAPoseThatIsNoneOrAFrameThatNoTransformLeadsTo_FLT_1) {
  EXPECT_EQ(problemOfWaypoint(inFrame("map")), "");
  EXPECT_EQ(problemOfWaypoint(inFrame("")), "no frame");
  geometry_msgs::PoseStamped nowhere = inFrame("map");
  nowhere.pose.position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(problemOfWaypoint(nowhere), "");
  EXPECT_EQ(problemOfWaypoints({inFrame("map"), inFrame("")}), "waypoint 2: no frame");
}

// [FLT-1] A thousand waypoints are kept, each with the name of its frame.
TEST(ProblemOfWaypoint, IsAFrameWhoseNameIsLongerThanTFTakes_FLT_1) {
  EXPECT_EQ(problemOfWaypoint(inFrame(std::string(256, 'm'))), "");
  EXPECT_EQ(problemOfWaypoint(inFrame(std::string(257, 'm'))), "the name of the frame has more than 256 characters");
}

}  // namespace
}  // namespace frontier_pilot
