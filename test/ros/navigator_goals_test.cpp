// What a client is told of a goal when the navigator's cycle fails.

#include <actionlib_msgs/GoalStatusArray.h>
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <string>
#include <vector>

#include "ros/navigator/navigator_action.h"
#include "wait_for.h"

namespace frontier_pilot {
namespace {

using actionlib_msgs::GoalStatus;
using test::serveUntil;

class NavigatorGoals : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(serveUntil([this] { return goals_.getNumSubscribers() > 0 && results_.getNumPublishers() > 0; }));
  }

  void sendGoal(const std::string& id) const {
    move_base_msgs::MoveBaseActionGoal goal;
    goal.goal_id.id = id;
    goal.goal.target_pose.header.frame_id = "map";
    goal.goal.target_pose.pose.orientation.w = 1.0;
    goals_.publish(goal);
  }
  /// The inputs of the cycle that takes the next goal.
  navigation::NavigatorInputs begun() {
    navigation::NavigatorInputs inputs;
    EXPECT_TRUE(serveUntil([&] {
      inputs = {};
      server_.fill(inputs);
      return inputs.new_goal.has_value();
    }));
    return inputs;
  }

  std::vector<GoalStatus> ended_;
  ros::NodeHandle node_;
  TfBridge tf_;
  MoveBaseServer server_{node_, tf_, "map", true};
  ros::Publisher goals_ = node_.advertise<move_base_msgs::MoveBaseActionGoal>("move_base/goal", 10);
  ros::Subscriber results_ = node_.subscribe<move_base_msgs::MoveBaseActionResult>(
      "move_base/result", 10,
      [this](const move_base_msgs::MoveBaseActionResult::ConstPtr& result) { ended_.push_back(result->status); });
};

// [FLT-1] [NAV-1] The goal that the failed cycle was to replace ends as well.
TEST_F(NavigatorGoals, AreAbortedAndCancelledAfterACycleThatFailedAndTheNextIsTaken_FLT_1_NAV_1) {
  sendGoal("a");
  begun();
  sendGoal("b");
  begun();
  server_.abortAll("internal error");
  EXPECT_FALSE(server_.goal());
  ASSERT_TRUE(serveUntil([this] { return ended_.size() == 2; }));
  for (const GoalStatus& status : ended_) {
    EXPECT_EQ(status.status, GoalStatus::ABORTED);
    EXPECT_EQ(status.text, "internal error");
  }
  sendGoal("c");
  EXPECT_TRUE(begun().new_goal);
  EXPECT_EQ(ended_.size(), 2U);
}

// [FLT-1]
TEST_F(NavigatorGoals, TheNavigatorIsToldToCancelWhatItPursued_FLT_1) {
  server_.abortAll("internal error");
  navigation::NavigatorInputs inputs;
  server_.fill(inputs);
  EXPECT_TRUE(inputs.cancel);
}

// [FLT-1] [NAV-1]
TEST_F(NavigatorGoals, IsToldSoAlsoIfAGoalThatWaitsIsCanceledMeanwhile_FLT_1) {
  sendGoal("a");
  begun();
  server_.abortAll("internal error");
  sendGoal("b");
  bool waits = false;
  const ros::Subscriber statuses = node_.subscribe<actionlib_msgs::GoalStatusArray>(
      "move_base/status", 10, [&](const actionlib_msgs::GoalStatusArray::ConstPtr& all) {
        for (const GoalStatus& status : all->status_list) waits |= status.goal_id.id == "b";
      });
  ASSERT_TRUE(serveUntil([&] { return waits; }));
  server_.setStopped(true);
  server_.setStopped(false);
  navigation::NavigatorInputs inputs;
  server_.fill(inputs);
  EXPECT_FALSE(inputs.new_goal);
  EXPECT_TRUE(inputs.cancel) << "it would drive on, for a goal that nobody has";
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "navigator_goals_test");
  const ros::NodeHandle keeps_ros_alive;
  return RUN_ALL_TESTS();
}
