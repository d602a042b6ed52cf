// The recovery, the faults and the switch of the avoider, tick by tick.
#include <gtest/gtest.h>

#include <stdexcept>

#include "frontier_pilot/avoid/avoider.h"
#include "scan_maker.h"

namespace frontier_pilot {
namespace {

constexpr avoid::AvoiderCommand kHold{{0.0, 0.0}, true};
constexpr avoid::AvoiderCommand kHeartbeat{{0.0, 0.0}, false};
constexpr avoid::AvoiderCommand kBack{{-0.08, 0.0}, false};
constexpr avoid::AvoiderCommand kLeft{{0.0, 0.7}, false};
constexpr avoid::AvoiderCommand kRight{{0.0, -0.7}, false};

class AvoiderTest : public ::testing::Test {
 protected:
  /// 100 ms pass, a scan of the world comes, and the node ticks.
  avoid::AvoiderCommand tick() {
    now += std::chrono::milliseconds(100);
    avoider.onScan(scan(), now);
    return avoider.tick(now).value_or(avoid::AvoiderCommand{{9.0, 9.0}, false});
  }
  std::vector<avoid::AvoiderCommand> ticks(int count) {
    std::vector<avoid::AvoiderCommand> commands;
    for (int i = 0; i < count; ++i) commands.push_back(tick());
    return commands;
  }
  LaserScan2 scan() const {
    LaserScan2 made = emptyScan({}, now);
    if (left > 0.0) putObstacle(made, 0.5, left);
    if (right > 0.0) putObstacle(made, -0.5, right);
    if (rear > 0.0) putObstacle(made, kPi, rear);
    return made;
  }

  avoid::Avoider avoider{avoid::AvoiderParameters{}};
  Time now = timeFromSeconds(100.0);
  double left = 0.0, right = 0.0, rear = 0.0;  ///< obstacles [m]; 0: none
};

// [AVO-3]
TEST_F(AvoiderTest, WhenClearSendsAHeartbeatOfZerosAtEveryTick_AVO_3) {
  EXPECT_EQ(ticks(20), std::vector<avoid::AvoiderCommand>(20, kHeartbeat)) << "[AVO-3]";
  EXPECT_EQ(avoider.state(), avoid::AvoiderState::kClear);
  left = right = 0.501;
  EXPECT_EQ(tick(), kHeartbeat) << "not nearer than stop_distance [AVO-3]";
}

// [AVO-3]
TEST_F(AvoiderTest, BacksUpFor400msAndTurnsFor800msAndRepeatsWithoutAnIdleTick_AVO_3) {
  tick();
  left = 0.4, right = 0.3;
  for (int cycle = 1; cycle <= 3; ++cycle) {
    EXPECT_EQ(ticks(4), std::vector<avoid::AvoiderCommand>(4, kBack)) << "cycle " << cycle << " [AVO-3]";
    EXPECT_EQ(ticks(8), std::vector<avoid::AvoiderCommand>(8, kLeft)) << "cycle " << cycle << " [AVO-3]";
    EXPECT_EQ(avoider.status(now).cycle, cycle);
  }
}

// [AVO-3]
TEST_F(AvoiderTest, TurnsLeftOnlyIfTheLeftIsFarther_AVO_3) {
  tick();
  left = 0.3, right = 0.3;
  ticks(4);
  EXPECT_EQ(tick(), kRight) << "equal: right [AVO-3]";
}

// [AVO-3]
TEST_F(AvoiderTest, HoldsTheDirectionForTheWholeEpisode_AVO_3) {
  tick();
  left = 0.45, right = 0.4;
  ticks(4);
  left = 0.3, right = 0.6;
  EXPECT_EQ(ticks(8), std::vector<avoid::AvoiderCommand>(8, kLeft)) << "[AVO-3]";
  ticks(4);
  EXPECT_EQ(tick(), kLeft) << "also in the next cycle [AVO-3]";
  left = right = 0.0;
  tick();
  left = 0.3, right = 0.4;
  ticks(4);
  EXPECT_EQ(tick(), kRight) << "a new episode chooses anew [AVO-3]";
}

// [AVO-3]
TEST_F(AvoiderTest, RecoveryStartsAndEndsWithTheVeryScanThatSaysSo_AVO_3) {
  tick();
  left = 0.499;
  EXPECT_EQ(avoider.onScan(scan(), now), kBack) << "at once, not at the next tick [AVO-3]";
  left = 0.65;
  EXPECT_EQ(tick(), kBack) << "0.65 is not beyond clear_distance [AVO-3]";
  left = 0.651;
  EXPECT_EQ(avoider.onScan(scan(), now), kHeartbeat) << "[AVO-3]";
  EXPECT_EQ(avoider.state(), avoid::AvoiderState::kClear);
}

// [AVO-3]
TEST_F(AvoiderTest, PhasesKeepTheirLengthWhenTicksAreUneven_AVO_3) {
  tick();
  left = 0.3;
  tick();
  const Time start = now;
  for (int i = 0; avoider.state() == avoid::AvoiderState::kReverse; ++i) {
    now += std::chrono::milliseconds(i % 2 == 0 ? 97 : 102);
    avoider.onScan(scan(), now);
    avoider.tick(now);
  }
  EXPECT_NEAR(toSeconds(now - start), 0.4, 0.011) << "[AVO-3]";
}

// [AVO-4]
TEST_F(AvoiderTest, SkipsReversingWhenSomethingIsBehind_AVO_4) {
  tick();
  left = 0.3, rear = 0.24;
  EXPECT_EQ(ticks(20), std::vector<avoid::AvoiderCommand>(20, kRight)) << "cycles of turning alone [AVO-4]";
  rear = 0.26;
  ticks(5);
  EXPECT_EQ(avoider.state(), avoid::AvoiderState::kReverse) << "room again: the next cycle reverses";
}

// [AVO-4]
TEST_F(AvoiderTest, DoesNotBeginToReverseWhenSomethingIsBehind_AVO_4) {
  tick();
  left = 0.3, rear = 0.24;
  now += std::chrono::milliseconds(100);
  EXPECT_EQ(avoider.onScan(scan(), now), kRight) << "not even for one message [AVO-4]";
}

// [AVO-3]
TEST_F(AvoiderTest, ExactlyStopDistanceDoesNotStartAndExactlyClearDistanceDoesNotEndARecovery_AVO_3) {
  avoid::AvoiderParameters parameters;
  parameters.clear_distance = 0.75;
  avoider = avoid::Avoider(parameters);
  LaserScan2 ahead = emptyScan({}, now);
  ahead.ranges[180] = 0.5F;
  avoider.onScan(ahead, now);
  EXPECT_EQ(avoider.state(), avoid::AvoiderState::kClear) << "[AVO-3]";
  ahead.ranges[180] = 0.25F;
  avoider.onScan(ahead, now);
  ahead.ranges[180] = 0.75F;
  avoider.onScan(ahead, now);
  EXPECT_EQ(avoider.state(), avoid::AvoiderState::kReverse) << "[AVO-3]";
}

// [AVO-4]
TEST_F(AvoiderTest, StopsReversingWhenSomethingComesNearBehind_AVO_4) {
  tick();
  left = 0.3;
  EXPECT_EQ(tick(), kBack);
  rear = 0.2;
  EXPECT_EQ(tick(), kRight) << "[AVO-4]";
}

// [AVO-5]
TEST_F(AvoiderTest, HoldsTheWheelsOnAnyFaultyScanAndSaysWhy_AVO_5) {
  tick();
  LaserScan2 bad = scan();
  bad.ranges.assign(360, std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(avoider.onScan(bad, now), kHold) << "[AVO-5]";
  EXPECT_EQ(avoider.status(now).reason, "360 of 360 beams are invalid");
  EXPECT_EQ(tick(), kHeartbeat) << "a good scan ends the fault";
  bad.ranges.clear();
  EXPECT_EQ(avoider.onScan(bad, now), kHold) << "[AVO-5]";
  tick();
  EXPECT_EQ(avoider.onBadScan("no transform", now), kHold) << "[AVO-5]";
  EXPECT_EQ(avoider.status(now).reason, "no transform");
  EXPECT_EQ(avoider.status(now).faults, 3U);
}

// [AVO-5]
TEST_F(AvoiderTest, HoldsWhenNoScanArrivesFor500ms_AVO_5) {
  tick();
  const Time last = now;
  now = last + std::chrono::milliseconds(500);
  EXPECT_EQ(avoider.tick(now), kHeartbeat);
  now += std::chrono::milliseconds(1);
  EXPECT_EQ(avoider.tick(now), kHold) << "[AVO-5]";
  EXPECT_EQ(avoider.state(), avoid::AvoiderState::kFault);
}

// [AVO-5]
TEST_F(AvoiderTest, HoldsWhenTheStampsAreOldOrFromTheFutureAlthoughScansArrive_AVO_5) {
  tick();
  LaserScan2 scan_of_then = scan();
  now += std::chrono::milliseconds(600);
  EXPECT_EQ(avoider.onScan(scan_of_then, now), kHold) << "[AVO-5]";
  EXPECT_EQ(avoider.status(now).reason, "the scan is old");
  scan_of_then.stamp = now + std::chrono::milliseconds(600);
  avoider.onScan(scan_of_then, now);
  EXPECT_EQ(avoider.status(now).reason, "the scan is from the future") << "such a scan would never grow old [AVO-5]";
}

// [AVO-5]
TEST_F(AvoiderTest, HoldsWhenNoScanArrivesAlthoughTheLastOneWasStampedAhead_AVO_5) {
  LaserScan2 ahead_of_time = emptyScan({}, now + std::chrono::milliseconds(400));
  avoider.onScan(ahead_of_time, now);
  now += std::chrono::milliseconds(501);
  EXPECT_EQ(avoider.tick(now), kHold) << "[AVO-5]";
  EXPECT_EQ(avoider.status(now).reason, "no scan arrives");
}

// [AVO-5]
TEST_F(AvoiderTest, HoldsBeforeTheFirstScanAndAfterTheClockJumpedBack_AVO_5) {
  EXPECT_EQ(avoider.tick(now), kHold) << "[AVO-5]";
  EXPECT_EQ(avoider.state(), avoid::AvoiderState::kWaiting);
  tick();
  now -= std::chrono::seconds(10);
  EXPECT_EQ(avoider.tick(now), kHold) << "[AVO-5]";
  EXPECT_EQ(avoider.state(), avoid::AvoiderState::kWaiting);
  EXPECT_EQ(tick(), kHeartbeat);
}

// [AVO-6]
TEST_F(AvoiderTest, GivesUpAfterMaxCyclesAndHoldsUntilTheWayIsClear_AVO_6) {
  tick();
  left = 0.3;
  ticks(12 * 12);
  EXPECT_EQ(tick(), kHold) << "[AVO-6]";
  EXPECT_EQ(avoider.state(), avoid::AvoiderState::kStuck);
  EXPECT_EQ(avoider.status(now).reason, "12 cycles did not free the way ahead");
  left = 0.6;
  EXPECT_EQ(tick(), kHold) << "not yet clear";
  left = 0.7;
  EXPECT_EQ(tick(), kHeartbeat);
}

// [AVO-6]
TEST_F(AvoiderTest, SwitchingOffGivesOneZeroAndThenSilence_AVO_6) {
  tick();
  left = 0.3;
  tick();
  EXPECT_EQ(avoider.setEnabled(false, now), kHeartbeat) << "one zero [AVO-6]";
  EXPECT_EQ(avoider.setEnabled(false, now), std::nullopt) << "idempotent";
  for (int i = 0; i < 5; ++i) {
    now += std::chrono::milliseconds(100);
    EXPECT_EQ(avoider.onScan(scan(), now), std::nullopt) << "[AVO-6]";
    EXPECT_EQ(avoider.onBadScan("bad", now), std::nullopt) << "[AVO-6]";
    EXPECT_EQ(avoider.tick(now), std::nullopt) << "[AVO-6]";
  }
  EXPECT_STREQ(toString(avoider.state()), "idle");
}

// [AVO-6]
TEST_F(AvoiderTest, SwitchingOnNeedsANewScan_AVO_6) {
  tick();
  avoider.setEnabled(false, now);
  EXPECT_EQ(avoider.setEnabled(true, now), kHold) << "[AVO-6]";
  EXPECT_EQ(avoider.tick(now), kHold) << "the scan of before does not count [AVO-6]";
  EXPECT_EQ(tick(), kHeartbeat);
}

TEST_F(AvoiderTest, WhatTheBodyWouldSweepBesideTheSectorsIsAvoidedToo) {
  tick();
  now += std::chrono::milliseconds(100);
  LaserScan2 beside = scan();
  putObstacle(beside, -80.0 * kPi / 180.0, 0.12, 0.0);
  EXPECT_EQ(avoider.onScan(beside, now), kBack);
  EXPECT_EQ(avoider.status(now).turn, 1) << "away from it";
}

TEST(AvoiderParameters, ImpossibleOnesAreRefusedByName) {
  avoid::AvoiderParameters parameters;
  const Problems problems = loadParameters(
      parseYaml("{clear_distance: 0.5, rear: {from: -2.0, to: 2.0}, reverse_speed: -0.1, turn_sped: 1.0}"), parameters);
  ASSERT_EQ(problems.size(), 4U);
  EXPECT_THROW(avoid::Avoider{parameters}, std::invalid_argument);
}

// [AVO-3]
TEST_F(AvoiderTest, OtherDistancesAndSpeedsHoldFromTheNextUpdateOn_AVO_3) {
  left = 0.7;
  EXPECT_EQ(tick(), kHeartbeat);
  avoid::AvoiderParameters changed;
  changed.stop_distance = 0.8, changed.clear_distance = 0.9, changed.reverse_speed = 0.05;
  avoider.setParameters(changed);
  EXPECT_EQ(tick(), (avoid::AvoiderCommand{{-0.05, 0.0}, false}));
  changed.stop_distance = 0.3, changed.clear_distance = 0.4;
  avoider.setParameters(changed);
  EXPECT_EQ(tick(), kHeartbeat) << "what was near is not near any more";
}

TEST_F(AvoiderTest, KeepsItsParametersWhenOthersDoNotPassTheCheck) {
  left = 0.4;
  avoid::AvoiderParameters bad;
  bad.stop_distance = 0.2, bad.clear_distance = 0.1;
  EXPECT_THROW(avoider.setParameters(bad), std::invalid_argument);
  EXPECT_EQ(tick(), kBack) << "by the distance it was made with";
}

}  // namespace
}  // namespace frontier_pilot
