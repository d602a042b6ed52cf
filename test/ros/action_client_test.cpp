// What a client hears of its goal where the server's messages come late, or not at all.

#include "ros/common/actions/action_client.h"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <string>
#include <vector>

#include "frontier_pilot/WaitAction.h"
#include "wait_for.h"

namespace frontier_pilot {
namespace {

using actionlib::TerminalState;
using actionlib_msgs::GoalID;
using actionlib_msgs::GoalStatus;
using actionlib_msgs::GoalStatusArray;
using test::serveUntil;

class ActionClients : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(comes([this] { return client_.isServerConnected(); }));
    send();
    ASSERT_TRUE(comes([this] { return !goal_.id.empty(); }));
  }

  void send() {
    client_.send({}, [this](const TerminalState& state, const WaitResultConstPtr& result) {
      ends_.push_back(state.toString() + ", " + state.getText() + (result ? ", with its result" : ""));
      others_at_the_end_ = client_.servesOthers();
    });
  }
  /// As a server that dies, and another that takes its place and has not published its status yet.
  void restart() {
    goals_.shutdown();
    ASSERT_TRUE(serveUntil([this] { return !client_.isServerConnected(); }));
    goal_ = {};
    status_.status_list.clear();
    goals_ = takeGoals();
  }

  /// Publishes the status over and over, as a server does, until the condition holds or the time is over.
  template <class Condition>
  bool comes(const Condition& condition, double seconds = 10.0) {
    const SteadyTime end = steadyNow() + std::chrono::milliseconds(static_cast<int>(seconds * 1e3));
    while (!condition() && steadyNow() < end) {
      statuses_.publish(status_);
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
    }
    return condition();
  }
  ros::Subscriber takeGoals() {
    return node_.subscribe<WaitActionGoal>("wait/goal", 10,
                                           [this](const WaitActionGoal::ConstPtr& goal) { goal_ = goal->goal_id; });
  }
  static GoalStatus goalOfSomebodyElse() {
    GoalStatus status;
    status.goal_id.id = "somebody-1";
    status.status = GoalStatus::ACTIVE;
    return status;
  }
  GoalStatus end(std::uint8_t state) const {
    GoalStatus status;
    status.goal_id = goal_;
    status.status = state;
    status.text = "no such shape";
    return status;
  }

  GoalID goal_;  ///< as the server heard it
  int canceled_ = 0;
  GoalStatusArray status_;
  std::vector<std::string> ends_;
  bool others_at_the_end_ = false;  ///< whether others were served when a goal ended
  ros::NodeHandle node_;
  ros::Publisher statuses_ = node_.advertise<GoalStatusArray>("wait/status", 10);
  ros::Publisher feedback_ = node_.advertise<WaitActionFeedback>("wait/feedback", 10);
  ros::Publisher results_ = node_.advertise<WaitActionResult>("wait/result", 10);
  ros::Subscriber goals_ = takeGoals();
  ros::Subscriber cancels_ =
      node_.subscribe<GoalID>("wait/cancel", 10, [this](const GoalID::ConstPtr&) { ++canceled_; });
  ActionClient<WaitAction> client_{node_, "wait"};
};

// [FLT-1]
TEST_F(ActionClients, TellTheEndOfAGoalWhoseResultWasLost) {
  status_.status_list = {end(GoalStatus::ABORTED)};
  EXPECT_TRUE(comes([this] { return !ends_.empty(); }, 5.0));
  comes([] { return false; }, 1.5);
  EXPECT_EQ(ends_, std::vector<std::string>{"ABORTED, no such shape"}) << "once";
}

// [FLT-1]
TEST_F(ActionClients, WaitAMomentForAResultThatComesAfterTheStatus) {
  status_.status_list = {end(GoalStatus::SUCCEEDED)};
  comes([] { return false; }, 0.3);
  EXPECT_TRUE(ends_.empty());
  WaitActionResult result;
  result.status = end(GoalStatus::SUCCEEDED);
  results_.publish(result);
  EXPECT_TRUE(comes([this] { return !ends_.empty(); }));
  comes([] { return false; }, 1.5);
  EXPECT_EQ(ends_, std::vector<std::string>{"SUCCEEDED, no such shape, with its result"});
}

// The server may pursue a goal whose end somebody else has announced. [FLT-2]
TEST_F(ActionClients, CancelAGoalThatIsPursuedAfterItsEndWasTold) {
  WaitActionResult result;
  result.status = end(GoalStatus::ABORTED);
  results_.publish(result);
  ASSERT_TRUE(comes([this] { return !ends_.empty(); }));
  status_.status_list = {end(GoalStatus::ACTIVE)};
  comes([] { return false; }, 0.5);
  EXPECT_EQ(canceled_, 0) << "the status may be older than the end";
  EXPECT_TRUE(comes([this] { return canceled_ > 0; }, 5.0));
}

// What a restarted server pursues is known only then. [EXP-11] [NAV-5]
TEST_F(ActionClients, AreConnectedToARestartedServerOnceTheyHaveHeardItsStatus) {
  restart();
  send();
  ASSERT_TRUE(serveUntil([this] { return !goal_.id.empty(); }));
  EXPECT_FALSE(client_.isServerConnected());
  EXPECT_TRUE(comes([this] { return client_.isServerConnected(); }));
}

// [NAV-5]
TEST_F(ActionClients, KnowTheGoalOfSomebodyElseWhenTheyAreToldThatTheirsIsLost) {
  status_.status_list = {end(GoalStatus::ACTIVE)};
  comes([] { return false; }, 0.3);
  restart();
  status_.status_list = {goalOfSomebodyElse()};
  ASSERT_TRUE(comes([this] { return !ends_.empty(); }));
  EXPECT_EQ(ends_.front().substr(0, 4), "LOST");
  EXPECT_TRUE(others_at_the_end_);
}

// [FLT-1]
TEST_F(ActionClients, TellThatAGoalIsLostWhichTheServerTookAlongBeforeItWasAcknowledged) {
  restart();
  ASSERT_TRUE(comes([this] { return !ends_.empty(); }));
  EXPECT_EQ(ends_, std::vector<std::string>{"LOST, the server did not report how the goal ended"});
}

// [EXP-11]
TEST_F(ActionClients, LeaveARestartedServerForAMomentToThoseWhomTheEarlierOneServed) {
  client_.forget();
  status_.status_list = {goalOfSomebodyElse()};
  ASSERT_TRUE(comes([this] { return client_.servesOthers(); }));
  restart();
  ASSERT_TRUE(comes([this] { return client_.isServerConnected(); }));
  EXPECT_TRUE(client_.servesOthers());
  EXPECT_TRUE(comes([this] { return !client_.servesOthers(); }));
}

// Somebody else's goal had just been replaced. [NAV-5]
TEST_F(ActionClients, LeaveItToNobodyIfTheirOwnGoalWasUnderWay) {
  status_.status_list = {end(GoalStatus::ACTIVE), goalOfSomebodyElse()};
  ASSERT_TRUE(comes([this] { return client_.servesOthers(); }));
  restart();
  ASSERT_TRUE(comes([this] { return !ends_.empty(); }));
  EXPECT_EQ(ends_.front().substr(0, 4), "LOST");
  EXPECT_FALSE(others_at_the_end_);
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "action_client_test");
  const ros::NodeHandle keeps_ros_alive;
  return RUN_ALL_TESTS();
}
