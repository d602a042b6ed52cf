// A timer on a clock that the test drives.

#include "ros/common/ros_timer.h"

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include "ros/common/clock.h"

namespace frontier_pilot {
namespace {

class RosTimers : public ::testing::Test {
 protected:
  /// Sets the clock, and whether the timer ticks `wanted` times then, within ten seconds.
  bool ticksAt(const ros::Time& time, int wanted) {
    ticks_ = 0;
    ros::Time::setNow(time);
    const SteadyTime end = steadyNow() + std::chrono::seconds(10);
    while (ticks_ < wanted && steadyNow() < end) serve();
    return ticks_ == wanted;
  }
  static void serve() { ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01)); }
  bool staysSilentAt(const ros::Time& time) {
    ticks_ = 0;
    ros::Time::setNow(time);
    for (int i = 0; i < 10; ++i) serve();
    return ticks_ == 0;
  }

  ros::NodeHandle node_;
  int ticks_ = 0;
  RosTimer timer_{node_, std::chrono::milliseconds(100), [this] { ++ticks_; }};
};

// [FLT-1]
TEST_F(RosTimers, TickOnAfterAFutureThatNeverWasAndAfterTheEndOfTime) {
  EXPECT_TRUE(staysSilentAt(ros::Time(100)));
  EXPECT_TRUE(ticksAt(ros::Time(100, 100000000), 1));
  for (const ros::Time& future : {ros::Time(1000100), ros::Time(4294967295U, 999999999U)}) {
    EXPECT_TRUE(ticksAt(future, 2)) << "one that was due, and one in time";
    EXPECT_TRUE(staysSilentAt(ros::Time(101))) << "a new period begins";
    EXPECT_TRUE(ticksAt(ros::Time(101, 100000000), 1));
    EXPECT_TRUE(ticksAt(ros::Time(101, 300000000), 2));
  }
}

}  // namespace
}  // namespace frontier_pilot

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "ros_timer_test");
  ros::Time::init();
  ros::Time::setNow(ros::Time(99));
  const ros::NodeHandle keeps_ros_alive;
  return RUN_ALL_TESTS();
}
