#include "frontier_pilot/core/clock_trust.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

/// Both clocks, driven by hand.
struct Clocks {
  Instant now{timeFromSeconds(100.0), timeFromSeconds<SteadyTime>(7.0)};

  const Instant& pass(double steady, double ros) {
    now.steady += fromSeconds(steady);
    now.ros += fromSeconds(ros);
    return now;
  }
};

// [FLT-1]
TEST(ClockTrust, IsLostByDaysForwardInNoTimeAndRegainedWhenTheClockHasRunOn) {
  Clocks clocks;
  ClockTrust trust;
  trust.observe(clocks.now);
  EXPECT_EQ(trust.observe(clocks.pass(0.01, 0.01)), TrustChange::kNone);
  EXPECT_EQ(trust.observe(clocks.pass(0.01, 1e6)), TrustChange::kLost);
  EXPECT_DOUBLE_EQ(trust.jump(), 1e6);
  EXPECT_EQ(trust.observe(clocks.pass(0.49, 0.49)), TrustChange::kNone);
  EXPECT_FALSE(trust.trusted());
  EXPECT_EQ(trust.observe(clocks.pass(0.02, 0.02)), TrustChange::kRegained);
  EXPECT_TRUE(trust.trusted());
}

TEST(ClockTrust, IsLostForAsLongAsTwoClocksSpeakAndABit) {
  Clocks clocks;
  ClockTrust trust;
  trust.observe(clocks.now);
  EXPECT_EQ(trust.observe(clocks.pass(0.01, 1e6)), TrustChange::kLost);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(trust.observe(clocks.pass(0.01, -1e6)), TrustChange::kNone);
    EXPECT_EQ(trust.observe(clocks.pass(0.01, 1e6)), TrustChange::kNone);
  }
  EXPECT_EQ(trust.observe(clocks.pass(0.01, -1e6)), TrustChange::kNone);
  EXPECT_EQ(trust.jumps(), 202U);
  EXPECT_EQ(trust.observe(clocks.pass(0.5, 0.5)), TrustChange::kRegained);
}

TEST(ClockTrust, IsLostByAnyStepBackward) {
  Clocks clocks;
  ClockTrust trust;
  trust.observe(clocks.now);
  EXPECT_EQ(trust.observe(clocks.pass(0.01, -0.01)), TrustChange::kLost);
}

TEST(ClockTrust, StaysThroughAFastSimulation) {
  Clocks clocks;
  ClockTrust trust;
  for (int i = 0; i < 100000; ++i) ASSERT_EQ(trust.observe(clocks.pass(0.02, 0.02 * 900.0)), TrustChange::kNone);
}

TEST(ClockTrust, StaysWhenAProcessHungAndCatchesUp) {
  for (const double speed : {1.0, 100.0}) {
    Clocks clocks;
    ClockTrust trust;
    trust.observe(clocks.now);
    EXPECT_EQ(trust.observe(clocks.pass(60.0, 0.01)), TrustChange::kNone);
    // What waited in the socket comes all at once.
    for (int i = 0; i < 60; ++i) ASSERT_EQ(trust.observe(clocks.pass(0.0001, speed)), TrustChange::kNone) << speed;
  }
}

TEST(ClockTrust, StaysThroughPausesAndTheFirstClockMessage) {
  Clocks clocks;
  clocks.now.ros = Time{};
  ClockTrust trust;
  trust.observe(clocks.now);
  EXPECT_EQ(trust.observe(clocks.pass(1.0, 1.7e9)), TrustChange::kNone);
  for (int i = 0; i < 1000; ++i) ASSERT_EQ(trust.observe(clocks.pass(1.0, 0.0)), TrustChange::kNone);
  EXPECT_EQ(trust.observe(clocks.pass(0.01, 0.01)), TrustChange::kNone);
}

TEST(ClockTrust, OfTheSystemsClockIsLostWhenItIsSetAndNotWhenItIsSlewed) {
  Clocks clocks;
  ClockTrust trust(kRealPace);
  for (int i = 0; i < 100000; ++i) ASSERT_EQ(trust.observe(clocks.pass(1.0, 1.0005)), TrustChange::kNone);
  EXPECT_EQ(trust.observe(clocks.pass(0.02, 60.0)), TrustChange::kLost);
}

}  // namespace
}  // namespace frontier_pilot
