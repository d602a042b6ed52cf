// The description of a robot, as its file gives it.

#include "frontier_pilot/core/robot_model.h"

#include <gtest/gtest.h>

#include <string>

namespace frontier_pilot {
namespace {

struct Node {
  RobotModel robot;

  template <class Visitor>
  void describe(Visitor& v) {
    describeRobot(v, robot);
    v.moved("inscribed_radius", "robot/disc_radius");
  }
};

Problems load(const std::string& yaml, Node& node) { return loadParameters(parseYaml(yaml), node); }

Problems problems(const std::string& yaml) {
  Node node;
  return load(yaml, node);
}

// [ROB-1]
TEST(RobotModels, TakeADiscForARoundRobotAndTheOutlineForAnother) {
  Node node;
  EXPECT_TRUE(node.robot.drivenOutline().isDisc());
  EXPECT_FALSE(node.robot.exactOutline().isDisc());
  EXPECT_TRUE(load("robot: {disc_radius: 0.0}", node).empty());
  EXPECT_FALSE(node.robot.drivenOutline().isDisc());
  EXPECT_TRUE(load("robot: {outline: [], disc_radius: 0.2}", node).empty());
  EXPECT_TRUE(node.robot.exactOutline().isDisc());
}

// [ROB-1]
TEST(RobotModels, AreRefusedWithEveryProblemByName) {
  EXPECT_EQ(problems("robot: {outline: [], disc_radius: 0.0, scanner: {range_min: 9.0}}"),
            (Problems{"robot/scanner/range_min: must be below range_max",
                      "robot/outline: must be given where disc_radius is 0"}));
  EXPECT_EQ(problems("robot: {outline: [0.1, 0.1, -0.1]}"), (Problems{"robot/outline: must be pairs x, y"}));
  EXPECT_EQ(problems("robot: {outline: [0.1, 0.1, -0.1, 0.1]}"),
            (Problems{"robot/outline: must have at least three corners"}));
  EXPECT_EQ(problems("robot: {outline: [0.3, 0.2, -0.3, 0.2, -0.3, -0.2, 0.3, -0.2], disc_radius: 1.0e-9}"),
            (Problems{"robot/disc_radius: must be 0 or at least half the width of the outline"}));
  EXPECT_EQ(problems("robot: {outline: [0.3, 0.1, -0.3, 0.1, -0.3, -0.1, 0.3, -0.1]}"),
            (Problems{"robot/disc_radius: must be 0 for an outline whose corners are so far out, or larger"}))
      << "it would be driven as a Burger's disc";
  EXPECT_EQ(problems("robot: {base_frame: " + std::string(300, 'a') + "}"),
            (Problems{"robot/base_frame: must have at most 256 characters"}));
  EXPECT_EQ(problems("robot: {base_frame: odom}"), (Problems{"robot/base_frame: is odom_frame as well, 'odom'"}));
  EXPECT_EQ(problems("robot: {base_frame: \"a\\nb\"}"),
            (Problems{"robot/base_frame: must not have control characters: no transform may have such a frame"}));
}

// [ROB-1]
TEST(RobotModels, HaveTheirLimitsOverriddenByTheNodesOwn) {
  Node node;
  EXPECT_TRUE(load("{limits: {max_linear: 0.5}, robot: {limits: {max_linear: 0.1, max_angular: 1.0}}}", node).empty());
  EXPECT_EQ(node.robot.limits.max_linear, 0.5);
  EXPECT_EQ(node.robot.limits.max_angular, 1.0);
}

TEST(RobotModels, SayWhatAnOldParameterIsCalledNow) {
  EXPECT_EQ(problems("inscribed_radius: 0.2"), (Problems{"inscribed_radius: is called robot/disc_radius now"}));
}

}  // namespace
}  // namespace frontier_pilot
