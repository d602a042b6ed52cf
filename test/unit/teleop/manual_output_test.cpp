#include "teleop/manual_output.h"

#include <gtest/gtest.h>

#include <limits>

namespace frontier_pilot {
namespace {

const Twist2 kForward{0.1, 0.0};

SteadyTime at(double seconds) { return timeFromSeconds<SteadyTime>(seconds); }

/// An output that has got `set_point` through at 0 s. A liveness timeout of 0.4 s.
teleop::ManualOutput liveOutput(const Twist2& set_point) {
  teleop::ManualOutput output(fromSeconds(0.4));
  output.beat({}, at(-0.1));
  output.update(true, at(-0.1));
  output.beat(set_point, at(0.0));
  output.update(true, at(0.0));
  return output;
}

TEST(ManualOutput, IsSilentBeforeTheFirstSignOfLife) {
  teleop::ManualOutput output(fromSeconds(0.4));
  EXPECT_FALSE(output.update(true, at(1.0)));
}

// [GUI-1]
TEST(ManualOutput, RepeatsTheSetPointWhileTheWindowLives) {
  teleop::ManualOutput output = liveOutput(kForward);
  for (int i = 1; i <= 10; ++i) {
    output.beat(kForward, at(0.1 * i));
    EXPECT_EQ(output.update(true, at(0.1 * i)), kForward);
  }
}

// [GUI-3]
TEST(ManualOutput, AFrozenWindowGetsOneZeroAndThenSilence) {
  teleop::ManualOutput output = liveOutput(kForward);
  EXPECT_EQ(output.update(true, at(0.4)), kForward);
  EXPECT_EQ(output.update(true, at(0.5)), Twist2{});
  EXPECT_EQ(output.state(), teleop::ManualOutput::State::kFrozen);
  EXPECT_FALSE(output.update(true, at(0.6)));
  EXPECT_FALSE(output.update(true, at(60.0)));
}

// [GUI-3]
TEST(ManualOutput, AWindowThatThawsDoesNotMoveTheRobotWithWhatWasAskedBefore) {
  teleop::ManualOutput output = liveOutput(kForward);
  output.update(true, at(0.5));
  output.beat(kForward, at(3.0));
  EXPECT_EQ(output.update(true, at(3.0)), Twist2{});
  output.beat({}, at(3.1));
  EXPECT_EQ(output.update(true, at(3.1)), Twist2{});
  output.beat(kForward, at(3.2));
  EXPECT_EQ(output.update(true, at(3.2)), kForward);
}

// [GUI-3]
TEST(ManualOutput, AProcessThatStoodStillAltogetherCountsAsFrozenToo) {
  teleop::ManualOutput output = liveOutput(kForward);
  output.beat(kForward, at(5.0));  // nobody asked for an update in between
  EXPECT_EQ(output.update(true, at(5.0)), Twist2{});
}

TEST(ManualOutput, SwitchedOffItSaysZeroOnceAndStartsAgainOnlyFromZero) {
  teleop::ManualOutput output = liveOutput(kForward);
  EXPECT_EQ(output.update(false, at(0.1)), Twist2{});
  EXPECT_FALSE(output.update(false, at(0.2)));
  output.beat(kForward, at(0.3));
  EXPECT_EQ(output.update(true, at(0.3)), Twist2{});
  EXPECT_EQ(output.state(), teleop::ManualOutput::State::kRearm);
}

// [GUI-1] The window may see that manual is on again, and a press come, before the next update.
TEST(ManualOutput, APressAfterAZeroCountsAlsoIfItComesBeforeTheUpdate) {
  teleop::ManualOutput output = liveOutput(kForward);
  EXPECT_EQ(output.update(false, at(0.1)), Twist2{});
  output.beat({}, at(0.15));
  output.beat(kForward, at(0.2));
  EXPECT_EQ(output.update(true, at(0.25)), kForward);
}

// [GUI-3]
TEST(ManualOutput, AZeroOfBeforeAFreezeDoesNotCount) {
  teleop::ManualOutput output = liveOutput(kForward);
  EXPECT_EQ(output.update(false, at(0.1)), Twist2{});
  output.beat({}, at(0.2));
  output.beat(kForward, at(5.0));
  EXPECT_EQ(output.update(true, at(5.0)), Twist2{});
}

// [GUI-3]
TEST(ManualOutput, NothingLeavesAfterTheZeroOfClosing) {
  teleop::ManualOutput output = liveOutput(kForward);
  EXPECT_EQ(output.close(), Twist2{});
  output.beat(kForward, at(0.1));
  EXPECT_FALSE(output.update(true, at(0.1)));
}

TEST(ManualOutput, ASetPointThatIsNotFiniteCountsAsZero) {
  teleop::ManualOutput output = liveOutput(kForward);
  output.beat({std::numeric_limits<double>::quiet_NaN(), 0.0}, at(0.1));
  EXPECT_EQ(output.update(true, at(0.1)), Twist2{});
}

TEST(ManualOutput, SaysWhyNothingLeavesIt) {
  teleop::ManualOutput output(fromSeconds(0.4));
  EXPECT_STREQ(toString(output.state()), "waiting for the window");
  output.beat(kForward, at(0.0));
  output.update(true, at(0.0));
  EXPECT_STREQ(toString(output.state()), "waiting for a zero set-point");
  output.beat({}, at(0.1));
  output.update(true, at(0.1));
  EXPECT_STREQ(toString(output.state()), "live");
  output.update(false, at(0.2));
  EXPECT_STREQ(toString(output.state()), "manual is switched off");
  output.update(true, at(1.0));
  EXPECT_STREQ(toString(output.state()), "the window is frozen");
  output.close();
  EXPECT_STREQ(toString(output.state()), "closed");
}

}  // namespace
}  // namespace frontier_pilot
