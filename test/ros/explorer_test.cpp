// The explorer on the wire, with a map and a move_base in the test's hands. The node lives through all tests: they tell
// one story, in order, and each ends where the next begins.

#include <actionlib/server/simple_action_server.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <frontier_pilot/ExplorerStatus.h>
#include <gtest/gtest.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <rosgraph_msgs/Log.h>
#include <std_msgs/Bool.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <memory>

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/tf/tf_bridge.h"
#include "wait_for.h"

namespace frontier_pilot {
namespace {

using test::serveUntil;

using Server = actionlib::SimpleActionServer<move_base_msgs::MoveBaseAction>;

/// A move_base that takes goals and ends them when the test says so.
class FakeMoveBase {
 public:
  explicit FakeMoveBase(ros::NodeHandle& node)
      : server_(node, names::kMoveBase, false),
        status_(node.advertise<actionlib_msgs::GoalStatusArray>(std::string(names::kMoveBase) + "/status", 10)) {
    server_.registerGoalCallback([this] { goals.push_back(server_.acceptNewGoal()->target_pose); });
    server_.registerPreemptCallback([this] {
      if (server_.isNewGoalAvailable()) return;
      ++cancels;
      server_.setPreempted();
    });
    server_.start();
  }
  void abort(const std::string& why) { server_.setAborted({}, why); }
  bool active() { return server_.isActive(); }
  /// As one that was restarted so fast that nobody noticed.
  void sayThatThereIsNoGoal() const { status_.publish(actionlib_msgs::GoalStatusArray()); }

  std::vector<geometry_msgs::PoseStamped> goals;
  int cancels = 0;

 private:
  Server server_;
  ros::Publisher status_;
};

/// What the explorer listens to, published at 20 Hz.
class FakeRobot {
 public:
  explicit FakeRobot(ros::NodeHandle& node) : odometry_(node.advertise<nav_msgs::Odometry>(names::kOdom, 10)) {
    timer_ = node.createSteadyTimer(ros::WallDuration(0.05), [this](const ros::SteadyTimerEvent&) {
      MotionSample odometry;
      odometry.stamp = rosNow();
      odometry_.publish(toOdometryMsg(odometry, names::kOdomFrame, names::kBaseFootprintFrame));
      tf_.broadcast(names::kMapFrame, names::kBaseFootprintFrame, Pose2(1.0, 1.0, 0.0), odometry.stamp);
    });
  }

 private:
  ros::Publisher odometry_;
  TfBridge tf_;
  ros::SteadyTimer timer_;
};

/// A hall of 5 m x 2 m whose right end is not known yet.
OccupancyGrid hall() {
  GridGeometry geometry;
  geometry.width = 100;
  geometry.height = 40;
  OccupancyGrid map(geometry, kOccupied);
  for (int y = 1; y < 39; ++y) {
    for (int x = 1; x < 100; ++x) map[Cell{x, y}] = x < 90 ? kFree : kUnknown;
  }
  return map;
}

class ExplorerOnTheWire : public ::testing::Test {
 protected:
  struct World {
    World() {
      status = node.subscribe<ExplorerStatus>(names::kExplorerStatus, 50, [this](const auto& msg) {
        latest = *msg;
        history.push_back(*msg);
      });
      marker = node.subscribe<visualization_msgs::MarkerArray>(names::kFrontiers, 5,
                                                               [this](const auto& msg) { markers = *msg; });
      log = node.subscribe<rosgraph_msgs::Log>("/rosout", 100, [this](const auto& msg) {
        if (msg->msg.find("exploration waits for") != std::string::npos) complaints.push_back(msg->msg);
      });
      map_publisher = node.advertise<nav_msgs::OccupancyGrid>(names::kMap, 1, true);
      update_publisher = node.advertise<map_msgs::OccupancyGridUpdate>(names::kMapUpdates, 10);
    }
    void fill(const CellRect& block, std::int8_t value) {
      for (int y = block.y; y < block.y + block.height; ++y) std::fill_n(map.row(y) + block.x, block.width, value);
      update_publisher.publish(toGridUpdateMsg(map, block, names::kMapFrame, rosNow()));
    }

    ros::NodeHandle node;
    ros::Subscriber status, marker, log;
    ros::Publisher map_publisher, update_publisher;
    ExplorerStatus latest;
    std::vector<ExplorerStatus> history;
    visualization_msgs::MarkerArray markers;
    std::vector<std::string> complaints;
    OccupancyGrid map = hall();
    std::unique_ptr<FakeRobot> robot;
    std::unique_ptr<FakeMoveBase> move_base;
  };

  static void SetUpTestSuite() { world = new World; }
  static void TearDownTestSuite() {
    delete world;
    world = nullptr;
  }

  static bool reaches(std::uint8_t state, double seconds = 10.0) {
    return serveUntil([&] { return world->latest.state == state; }, fromSeconds(seconds));
  }
  static bool wentThrough(std::uint8_t reason) {
    return serveUntil([&] {
      return std::any_of(world->history.begin(), world->history.end(),
                         [&](const ExplorerStatus& s) { return s.reason == reason; });
    });
  }
  static bool shows(const std::string& marker_namespace) {
    return serveUntil([&] {
      const auto& all = world->markers.markers;
      return std::any_of(all.begin(), all.end(), [&](const auto& m) { return m.ns == marker_namespace; });
    });
  }

  static World* world;
};
ExplorerOnTheWire::World* ExplorerOnTheWire::world = nullptr;

// [EXP-7]
TEST_F(ExplorerOnTheWire, A_DoesNothingUntilItIsAskedTo_EXP_7) {
  ASSERT_TRUE(serveUntil([] { return !world->history.empty(); }));
  EXPECT_EQ(world->latest.state, ExplorerStatus::IDLE);
  EXPECT_EQ(world->latest.reason, ExplorerStatus::PAUSED);
  std_srvs::SetBool explore;
  explore.request.data = 1;
  ASSERT_TRUE(ros::service::call(names::kSetExplorationEnabled, explore));
  EXPECT_EQ(explore.response.message, "exploration enabled") << "it was not enabled before";
}

// [EXP-8]
TEST_F(ExplorerOnTheWire, B_WaitsAndNamesWhatIsMissing_EXP_8) {
  ASSERT_TRUE(serveUntil([] { return world->complaints.size() >= 2; }));
  EXPECT_NE(world->complaints.back().find("map, odometry, TF from map to base, move_base"), std::string::npos);
  EXPECT_EQ(world->latest.state, ExplorerStatus::IDLE);
  EXPECT_EQ(world->latest.reason, ExplorerStatus::WAITING_FOR_INPUTS);
  world->robot = std::make_unique<FakeRobot>(world->node);
  world->map_publisher.publish(toOccupancyGridMsg(world->map, names::kMapFrame, rosNow()));
  EXPECT_TRUE(serveUntil([] { return world->latest.reason_text.rfind("missing: move_base", 0) == 0; }))
      << world->latest.reason_text;
}

// [EXP-1] [EXP-2]
TEST_F(ExplorerOnTheWire, C_SendsAGoalOnFreeGroundAndShowsTheFrontiers_EXP_1) {
  world->move_base = std::make_unique<FakeMoveBase>(world->node);
  ASSERT_TRUE(reaches(ExplorerStatus::NAVIGATING));
  ASSERT_TRUE(serveUntil([] { return !world->move_base->goals.empty(); }));
  const auto& goal = world->move_base->goals.front();
  EXPECT_EQ(goal.header.frame_id, names::kMapFrame);
  const Cell cell = world->map.geometry().cellAt({goal.pose.position.x, goal.pose.position.y});
  EXPECT_TRUE(isFree(world->map.get(cell, kUnknown)));
  EXPECT_TRUE(shows("cells") && shows("centroids") && shows("scores"));
  EXPECT_EQ(world->latest.goals_sent, 1U);
  EXPECT_NEAR(world->latest.explored_area, 89 * 38 * 0.0025, 1e-6);
}

// [EXP-5]
TEST_F(ExplorerOnTheWire, D_ATimedOutGoalIsCancelledAndBlacklisted_EXP_5) {
  ASSERT_TRUE(wentThrough(ExplorerStatus::GOAL_TIMED_OUT));
  EXPECT_TRUE(serveUntil([] { return world->move_base->cancels >= 1; })) << "[EXP-5]";
  EXPECT_TRUE(shows("blacklist")) << "in red";
  EXPECT_TRUE(shows("rejected: blacklisted") || world->latest.reason == ExplorerStatus::BLACKLIST_SATURATED);
}

// [EXP-8]
TEST_F(ExplorerOnTheWire, E_AVanishedMoveBaseStopsItAndItResumes_EXP_8) {
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call(names::kResetExplorer, reset));
  ASSERT_TRUE(reaches(ExplorerStatus::NAVIGATING));
  std_srvs::Trigger explain;
  ASSERT_TRUE(ros::service::call(names::kExplainExplorer, explain));
  EXPECT_NE(explain.response.message.find("The goal is ("), std::string::npos)
      << explain.response.message << " [EXP-9]";
  EXPECT_NE(explain.response.message.find("first of 1 stops"), std::string::npos) << explain.response.message;
  world->move_base.reset();
  ASSERT_TRUE(reaches(ExplorerStatus::IDLE));
  EXPECT_EQ(world->latest.reason, ExplorerStatus::NAVIGATION_GONE);
  EXPECT_EQ(world->latest.reason_text.rfind("missing: move_base", 0), 0U) << world->latest.reason_text;
  world->move_base = std::make_unique<FakeMoveBase>(world->node);
  EXPECT_TRUE(reaches(ExplorerStatus::NAVIGATING)) << "[EXP-8]";
  EXPECT_TRUE(serveUntil([] { return world->move_base->active(); }));
}

// [EXP-8]
TEST_F(ExplorerOnTheWire, E_AGoalThatTheNavigationLosesIsNoFailureOfItsPlace_EXP_8) {
  const std::uint32_t failed = world->latest.goals_failed;
  for (int times = 0; times < 2; ++times) {
    EXPECT_TRUE(serveUntil([] {
      world->move_base->sayThatThereIsNoGoal();
      return world->latest.reason == ExplorerStatus::NAVIGATION_UNABLE;
    })) << world->latest.reason_text;
    ASSERT_TRUE(reaches(ExplorerStatus::NAVIGATING)) << "it is tried again";
    ASSERT_TRUE(serveUntil([] { return world->move_base->active(); }));
  }
  EXPECT_EQ(world->latest.goals_failed, failed);
  EXPECT_EQ(world->latest.frontiers_blacklisted, 0U);
}

// [EXP-7]
TEST_F(ExplorerOnTheWire, F_APauseCancelsTheGoal_EXP_7) {
  std_srvs::SetBool pause;
  pause.request.data = 0;
  ASSERT_TRUE(ros::service::call(names::kSetExplorationEnabled, pause));
  EXPECT_TRUE(pause.response.success);
  EXPECT_TRUE(serveUntil([] { return !world->move_base->active(); }));
  EXPECT_TRUE(serveUntil([] { return world->latest.reason == ExplorerStatus::PAUSED; }));
  pause.request.data = 1;
  ASSERT_TRUE(ros::service::call(names::kSetExplorationEnabled, pause));
  EXPECT_TRUE(serveUntil([] { return world->move_base->active(); }));
}

// [ARB-8] Nothing is driven to while the robot is stopped, and after the clear it does not drive off.
TEST_F(ExplorerOnTheWire, F_AStopCancelsTheGoalAndItsClearPauses_ARB_8) {
  ros::Publisher stop = world->node.advertise<std_msgs::Bool>(names::kEmergencyStopState, 10, true);
  std_msgs::Bool stopped;
  stopped.data = 1;
  stop.publish(stopped);
  EXPECT_TRUE(serveUntil([] { return !world->move_base->active(); }));
  EXPECT_TRUE(serveUntil([] { return world->latest.reason == ExplorerStatus::EMERGENCY_STOP; }));
  std_srvs::SetBool go_on;
  go_on.request.data = 1;
  ASSERT_TRUE(ros::service::call(names::kSetExplorationEnabled, go_on));
  EXPECT_NE(go_on.response.message.find("clearing the stop pauses it"), std::string::npos) << go_on.response.message;
  stopped.data = 0;
  stop.publish(stopped);
  EXPECT_TRUE(serveUntil([] { return world->latest.reason == ExplorerStatus::PAUSED; }));
  EXPECT_FALSE(world->move_base->active());
  ASSERT_TRUE(ros::service::call(names::kSetExplorationEnabled, go_on));
  EXPECT_EQ(go_on.response.message, "exploration enabled");
  EXPECT_TRUE(serveUntil([] { return world->move_base->active(); }));
}

// A broken map is refused, and what was known is kept.
TEST_F(ExplorerOnTheWire, G_AMapOfTheWrongLengthLosesNothing) {
  const double area = world->latest.explored_area;
  nav_msgs::OccupancyGrid broken = toOccupancyGridMsg(world->map, names::kMapFrame, rosNow());
  broken.data.resize(7);
  world->map_publisher.publish(broken);
  const std::size_t seen = world->history.size();
  ASSERT_TRUE(serveUntil([&] { return world->history.size() >= seen + 2; }));
  EXPECT_EQ(world->latest.explored_area, area);
}

// [EXP-7]
TEST_F(ExplorerOnTheWire, H_IsDoneWhenNothingIsLeftAndAnOpenedDoorWakesIt_EXP_7) {
  world->map_publisher.publish(toOccupancyGridMsg(world->map, names::kMapFrame, rosNow()));
  world->fill({90, 1, 10, 38}, kOccupied);
  ASSERT_TRUE(reaches(ExplorerStatus::DONE)) << world->latest.state_text << " " << world->latest.reason_text;
  EXPECT_EQ(world->latest.reason, ExplorerStatus::NO_REACHABLE_FRONTIER);
  EXPECT_TRUE(serveUntil([] { return !world->move_base->active(); }));
  world->fill({90, 10, 5, 20}, kFree);
  world->fill({95, 10, 5, 20}, kUnknown);
  EXPECT_TRUE(reaches(ExplorerStatus::NAVIGATING));
  EXPECT_TRUE(wentThrough(ExplorerStatus::MAP_CHANGED));
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "explorer_test");
  const ros::NodeHandle keeps_ros_alive;
  return RUN_ALL_TESTS();
}
