#include "ros/common/tf/fixed_frames.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

geometry_msgs::TransformStamped link(const std::string& parent, const std::string& child, double x = 0.0) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = parent;
  transform.child_frame_id = child;
  transform.transform.translation.x = x;
  transform.transform.rotation.w = 1.0;
  return transform;
}

SteadyTime at(double seconds) { return SteadyTime() + fromSeconds(seconds); }

// [FLT-1]
TEST(FixedFrames, TheFirstStaticTransformOfAFrameHolds_FLT_1) {
  FixedFrames frames;
  EXPECT_EQ(frames.objection(link("base", "scan", 0.1), true, at(0.0)), "");
  EXPECT_EQ(frames.objection(link("/base", "/scan", 0.1), true, at(1.0)), "") << "the same again";
  EXPECT_NE(frames.objection(link("base", "scan", 0.2), true, at(11.0)), "");
  EXPECT_NE(frames.objection(link("other", "scan"), false, at(11.0)), "");
  EXPECT_NE(frames.objection(link("base", "scan", 0.2), false, at(11.0)), "") << "tf2 would take it over for all times";
  EXPECT_EQ(frames.objection(link("base", "scan", 0.1), false, at(11.0)), "");
  EXPECT_EQ(frames.takeDisputed(), "");
}

// [FLT-1] What somebody has left behind on /tf_static may reach a node that is started again before the true transform.
TEST(FixedFrames, AFrameIsDisputedThatIsFixedInTwoPlacesFromTheStart_FLT_1) {
  FixedFrames frames;
  EXPECT_EQ(frames.objection(link("base", "scan", 0.2), true, at(0.0)), "");
  EXPECT_NE(frames.objection(link("base", "scan", 0.1), true, at(9.0)), "");
  EXPECT_EQ(frames.takeDisputed(), "scan");
  EXPECT_EQ(frames.takeDisputed(), "") << "told once";
  EXPECT_NE(frames.objection(link("base", "scan", 0.1), true, at(60.0)), "");
  EXPECT_NE(frames.objection(link("base", "scan", 0.2), true, at(60.0)), "") << "the first one is not believed either";
  EXPECT_EQ(frames.takeDisputed(), "");
}

// [FLT-1]
TEST(FixedFrames, AFrameIsDisputedThatIsFixedAndMovesFromTheStart_FLT_1) {
  FixedFrames frames;
  EXPECT_EQ(frames.objection(link("map", "odom"), true, at(0.0)), "");
  int told = 0;
  for (int i = 0; i < 100; ++i) {
    EXPECT_NE(frames.objection(link("map", "odom", 1.0), false, at(0.05 * i)), "");
    if (frames.takeDisputed() == "odom") ++told;
    EXPECT_EQ(told, i < 19 ? 0 : 1) << "a message or two are none that moves it";
  }
}

// [FLT-1] It would nail the robot to the floor for good: the transforms of its odometry would be refused.
TEST(FixedFrames, AFrameThatMovesDoesNotBecomeFixed_FLT_1) {
  FixedFrames frames;
  EXPECT_EQ(frames.objection(link("odom", "base"), false, at(0.0)), "");
  EXPECT_NE(frames.objection(link("nowhere", "base"), true, at(4.9)), "");
  EXPECT_NE(frames.objection(link("odom", "base"), true, at(4.9)), "");
  EXPECT_EQ(frames.objection(link("odom", "base", 1.0), false, at(4.9)), "") << "the robot goes on";
}

// [FLT-1] A simulator that is paused, or a driver that is restarted, is silent for longer than a few seconds.
TEST(FixedFrames, AFrameThatHasMovedForAWhileNeverBecomesFixed_FLT_1) {
  FixedFrames frames;
  for (int i = 0; i < 30; ++i) EXPECT_EQ(frames.objection(link("odom", "base", 0.01 * i), false, at(0.02 * i)), "");
  EXPECT_NE(frames.objection(link("nowhere", "base"), true, at(600.0)), "");
  EXPECT_EQ(frames.objection(link("odom", "base", 1.0), false, at(601.0)), "") << "the robot goes on";
}

// [FLT-1] One message before the static one has come must not keep that out for good.
TEST(FixedFrames, AFrameOfWhichASingleTransformWasHeardLongAgoMayBecomeFixed_FLT_1) {
  FixedFrames frames;
  EXPECT_EQ(frames.objection(link("base", "scan", 7.0), false, at(0.0)), "");
  EXPECT_EQ(frames.objection(link("base", "scan", 0.1), true, at(5.1)), "");
}

}  // namespace
}  // namespace frontier_pilot
