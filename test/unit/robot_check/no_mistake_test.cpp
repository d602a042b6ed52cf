#include <gtest/gtest.h>

#include <string>

#include "robot_check/findings.h"
#include "seen_robot.h"

namespace frontier_pilot::robot_check {
namespace {

// [ROB-3]
TEST(RobotCheck, ARobotWithoutMistakesCouldDrive_ROB_3) {
  const SeenRobot robot;
  const Findings findings = judge(robot.seen, robot.expected);
  EXPECT_TRUE(couldDrive(findings)) << toText(findings);
  EXPECT_NE(toText(findings).find("The robot could drive."), std::string::npos);
  EXPECT_NE(
      toText(findings).find("0.05 m ahead of the base's origin, 0.02 m to the right, 0.20 m up, turned by 172 deg"),
      std::string::npos)
      << toText(findings);
}

// [ROB-2]
TEST(RobotCheck, AScannerUpsideDownIsNoMistake_ROB_2) {
  SeenRobot robot;
  robot.seen.links[1].T_parent_child.rotate(Eigen::AngleAxisd(kPi, Eigen::Vector3d::UnitX()));
  const Findings findings = judge(robot.seen, robot.expected);
  EXPECT_TRUE(couldDrive(findings)) << toText(findings);
  EXPECT_NE(toText(findings).find("upside down"), std::string::npos) << toText(findings);
}

// [ROB-2]
TEST(RobotCheck, AScannerThatLooksBackAndIsMountedBackwardsIsNoMistake_ROB_2) {
  SeenRobot robot;  // whose scanner is turned by 172 degrees
  robot.seen.scan.last->angle_min = kPi / 2.0;
  robot.seen.scan.last->ranges.resize(180);
  EXPECT_TRUE(couldDrive(judge(robot.seen, robot.expected)));
}

// [ROB-2]
TEST(RobotCheck, StampsATenthOfASecondAheadOrBehindAreNoMistake_ROB_2) {
  for (const double lag : {-0.09, 0.09}) {
    SeenRobot robot;
    robot.seen.scan.lag = robot.seen.odometry.lag = robot.seen.links[0].stream.lag = lag;
    EXPECT_TRUE(couldDrive(judge(robot.seen, robot.expected))) << lag;
  }
}

// [SCN-2]
TEST(RobotCheck, TheTimesOfTheBeamsAreNoMistakeWhereTheNodesTakeThem_SCN_2) {
  const auto saysNothing = [](bool rolling, double in_file, double of_driver) {
    SeenRobot robot;
    robot.expected.robot.scanner.rolling = rolling;
    robot.expected.robot.scanner.time_increment = in_file;
    robot.seen.scan.time_increment = of_driver;
    return toText(judge(robot.seen, robot.expected)).find("times of the beams") == std::string::npos;
  };
  EXPECT_TRUE(saysNothing(true, -1.0, 0.1 / 360.0)) << "a driver that is right";
  EXPECT_TRUE(saysNothing(false, -1.0, 0.0)) << "a scanner that measures all beams at once";
  EXPECT_TRUE(saysNothing(true, 0.0, 0.0)) << "the robot's file says that they are measured at once";
  EXPECT_TRUE(saysNothing(true, 0.1 / 360.0, 1.0)) << "the robot's file gives them";
}

// [ROB-3]
TEST(RobotCheck, OurOwnMapperAndArbiterAreNoMistake_ROB_3) {
  SeenRobot robot;
  robot.seen.links.push_back(link("map", "odom", {}, 0.0, "/mapper", false));
  robot.seen.providers["/mapper/save_map"] = "/mapper";
  robot.addOwnNodes();
  robot.topic("/map").publishers = {"/mapper"};
  const Findings findings = judge(robot.seen, robot.expected);
  EXPECT_TRUE(couldDrive(findings)) << toText(findings);
  EXPECT_NE(toText(findings).find("/drive is obeyed by /base\n"), std::string::npos) << toText(findings);
}

// [ROB-3]
TEST(RobotCheck, NoneOfOurOwnNodesIsABase_ROB_3) {
  for (const char* node : {"/teleop_gui", "/cmd_vel_arbiter", "/obstacle_avoider", "/patrol_server"}) {
    SeenRobot robot;
    robot.addOwnNodes();
    robot.topic("/drive").subscribers = {node};
    EXPECT_FALSE(couldDrive(judge(robot.seen, robot.expected))) << node;
  }
}

}  // namespace
}  // namespace frontier_pilot::robot_check
