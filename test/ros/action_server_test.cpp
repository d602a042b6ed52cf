// What a client is told of a goal that its owner does nothing about.

#include "ros/common/actions/action_server.h"

#include <gtest/gtest.h>
#include <ros/ros.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "frontier_pilot/WaitAction.h"
#include "wait_for.h"

namespace frontier_pilot {
namespace {

using actionlib_msgs::GoalID;
using actionlib_msgs::GoalStatus;
using actionlib_msgs::GoalStatusArray;
using test::serveUntil;

class ActionServers : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(serveUntil([this] {
      return goals_.getNumSubscribers() > 0 && cancels_.getNumSubscribers() > 0 && results_.getNumPublishers() > 0;
    }));
  }

  void TearDown() override { ros::Time::init(); }  ///< with the time of the system again

  static GoalID named(const std::string& id) {
    GoalID goal_id;
    goal_id.id = id;
    return goal_id;
  }
  void sendGoal(const std::string& id) const {
    WaitActionGoal goal;
    goal.goal_id = named(id);
    goals_.publish(goal);
  }
  /// Whether exactly one goal has ended, so named and so.
  bool endsAs(const std::string& id, std::uint8_t state) {
    return serveUntil([this] { return !ended_.empty(); }) && ended_.size() == 1 && ended_[0].goal_id.id == id &&
           ended_[0].status == state;
  }

  bool fails_ = false;
  int begun_ = 0;
  int canceled_ = 0;
  std::vector<GoalStatus> ended_;
  std::string known_;  ///< the goal that the status names last
  ros::NodeHandle node_;
  SingleGoalServer<WaitAction> server_{node_, "wait",
                                       [this](const WaitGoal&) {
                                         if (fails_) throw std::runtime_error("no wheels");
                                         ++begun_;
                                       },
                                       [this](const std::string&) { ++canceled_; }};
  ros::Publisher goals_ = node_.advertise<WaitActionGoal>("wait/goal", 10);
  ros::Publisher cancels_ = node_.advertise<GoalID>("wait/cancel", 10);
  ros::Subscriber results_ = node_.subscribe<WaitActionResult>(
      "wait/result", 10, [this](const WaitActionResult::ConstPtr& result) { ended_.push_back(result->status); });
  ros::Subscriber statuses_ =
      node_.subscribe<GoalStatusArray>("wait/status", 10, [this](const GoalStatusArray::ConstPtr& status) {
        known_ = status->status_list.empty() ? std::string() : status->status_list.back().goal_id.id;
      });
};

// [FLT-1]
TEST_F(ActionServers, AbortAGoalThatCannotBeStartedAndTakeTheNext) {
  fails_ = true;
  sendGoal("a");
  EXPECT_TRUE(endsAs("a", GoalStatus::ABORTED));
  EXPECT_EQ(canceled_, 1) << "what may have begun is ended as well";
  fails_ = false;
  sendGoal("b");
  EXPECT_TRUE(serveUntil([this] { return begun_ == 1; }));
}

// [FLT-1]
TEST_F(ActionServers, EndACanceledGoalAlsoWhereTheOwnerDoesNot) {
  sendGoal("a");
  ASSERT_TRUE(serveUntil([this] { return begun_ == 1; }));
  cancels_.publish(named("a"));
  EXPECT_TRUE(endsAs("a", GoalStatus::PREEMPTED));
}

// [FLT-1]
TEST_F(ActionServers, RecallAGoalWhoseCancelCameFirst) {
  cancels_.publish(named("early"));
  ASSERT_TRUE(serveUntil([this] { return known_ == "early"; }));
  sendGoal("early");
  EXPECT_TRUE(endsAs("early", GoalStatus::RECALLED));
  EXPECT_EQ(begun_, 0);
  EXPECT_EQ(canceled_, 1) << "the owner may pursue a goal of another action";
}

// A link that was away delivers the goal when it is back. [NAV-1]
TEST_F(ActionServers, RecallAGoalThatComesLongAfterItsCancel) {
  cancels_.publish(named("early"));
  ASSERT_TRUE(serveUntil([this] { return known_ == "early"; }));
  ros::Time::setNow(ros::Time::now() + ros::Duration(60.0));
  EXPECT_TRUE(serveUntil([this] { return known_.empty(); })) << "to clients it would be a goal that is pursued";
  sendGoal("early");
  EXPECT_TRUE(endsAs("early", GoalStatus::RECALLED));
  EXPECT_EQ(begun_, 0);
}

// A goal from rviz and the cancel of all goals that follows it arrive on two topics. [NAV-1]
TEST_F(ActionServers, BeginAGoalFromWithinTheNodeAtOnceAndOnlyOnce) {
  int begun = 0;
  std::vector<ActionServer<WaitAction>::GoalHandle> handles;
  ActionServer<WaitAction> server(
      node_, "within",
      [&](ActionServer<WaitAction>::GoalHandle handle) {
        ++begun;
        handle.setAccepted();
        handles.push_back(handle);
      },
      [&](ActionServer<WaitAction>::GoalHandle handle) { handle.setCanceled(); }, [] {});
  std::vector<GoalStatus> ended;
  const ros::Subscriber results = node_.subscribe<WaitActionResult>(
      "within/result", 10, [&](const WaitActionResult::ConstPtr& result) { ended.push_back(result->status); });
  const ros::Publisher goals = node_.advertise<WaitActionGoal>("within/goal", 10);
  const ros::Publisher cancels = node_.advertise<GoalID>("within/cancel", 10);
  ASSERT_TRUE(serveUntil([&] { return goals.getNumSubscribers() > 0 && cancels.getNumSubscribers() > 0; }));
  const auto goal = server.offer({});
  EXPECT_EQ(begun, 1) << "before any callback is called";
  goals.publish(goal);
  cancels.publish(GoalID());
  ASSERT_TRUE(serveUntil([&] { return !ended.empty(); }));
  EXPECT_EQ(ended.back().status, GoalStatus::PREEMPTED);
  EXPECT_FALSE(serveUntil([&] { return begun > 1 || ended.size() > 1; }, std::chrono::seconds(1)));
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "action_server_test");
  const ros::NodeHandle keeps_ros_alive;
  return RUN_ALL_TESTS();
}
