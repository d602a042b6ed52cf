// Faults of the scan in the middle of a recovery, and scanners that do not look back.
#include <gtest/gtest.h>

#include "frontier_pilot/avoid/avoider.h"
#include "scan_maker.h"

namespace frontier_pilot {
namespace {

using avoid::AvoiderState;

class InterruptedAvoider : public ::testing::Test {
 protected:
  /// 100 ms pass, and a scan comes; gives what the avoider commands then.
  avoid::AvoiderCommand tick() {
    now += std::chrono::milliseconds(100);
    LaserScan2 scan = emptyScan(scanner, now);
    if (left > 0.0) putObstacle(scan, 0.5, left);
    if (right > 0.0) putObstacle(scan, -0.5, right);
    if (blind_behind > 0.0) putObstacle(scan, kPi, std::numeric_limits<double>::quiet_NaN(), blind_behind);
    avoider.onScan(scan, now);
    return avoider.tick(now).value_or(avoid::AvoiderCommand{{9.0, 9.0}, false});
  }
  void ticks(int count) {
    for (int i = 0; i < count; ++i) tick();
  }
  void badScan() {
    now += std::chrono::milliseconds(100);
    avoider.onBadScan("no transform", now);
    EXPECT_EQ(avoider.state(), AvoiderState::kFault);
    EXPECT_EQ(avoider.status(now).turn, 0) << "it does not turn";
  }

  avoid::Avoider avoider{avoid::AvoiderParameters{}};
  Time now = timeFromSeconds(100.0);
  ScannerLayout scanner;
  double left = 0.0, right = 0.0;  ///< obstacles [m]; 0: none
  double blind_behind = 0.0;       ///< half the angle behind in which no beam is valid [rad]
};

// [ARB-8] The avoider asks for no motion while the robot is stopped, so that the stop can be cleared, and not after it.
TEST_F(InterruptedAvoider, RestsFromAStopOnUntilAnotherSourceDrives_ARB_8) {
  left = 0.3;
  tick();
  ASSERT_EQ(avoider.state(), AvoiderState::kReverse);
  EXPECT_EQ(avoider.setResting("waits for a driver", now), (avoid::AvoiderCommand{{0.0, 0.0}, false})) << "at once";
  ticks(20);
  EXPECT_EQ(tick(), (avoid::AvoiderCommand{{0.0, 0.0}, false})) << "[ARB-8]";
  EXPECT_EQ(avoider.status(now).reason, "obstacle ahead: waits for a driver");
  badScan();
  EXPECT_EQ(tick(), (avoid::AvoiderCommand{{0.0, 0.0}, false})) << "a fault does not bring the recovery back";
  left = 0.0;
  tick();
  EXPECT_EQ(avoider.status(now).reason, "nothing near ahead");
  left = 0.3;
  tick();
  EXPECT_EQ(avoider.setResting("", now), (avoid::AvoiderCommand{{-0.08, 0.0}, false})) << "at once [AVO-3]";
}

// [AVO-6]
TEST_F(InterruptedAvoider, StaysStuckAfterAFaultAsLongAsTheWayIsNotClear_AVO_6) {
  left = 0.3;
  ticks(12 * 12 + 1);
  ASSERT_EQ(avoider.state(), AvoiderState::kStuck);
  badScan();
  tick();
  EXPECT_EQ(avoider.state(), AvoiderState::kStuck) << "[AVO-6]";
  EXPECT_EQ(avoider.status(now).reason, "12 cycles did not free the way ahead");
  now += std::chrono::milliseconds(600);
  avoider.update(now);
  ASSERT_EQ(avoider.status(now).reason, "no scan arrives");
  EXPECT_EQ(tick(), (avoid::AvoiderCommand{{0.0, 0.0}, true})) << "also after a gap [AVO-6]";
  badScan();
  left = 0.0;
  tick();
  EXPECT_EQ(avoider.state(), AvoiderState::kClear);
  left = 0.3;
  tick();
  EXPECT_EQ(avoider.state(), AvoiderState::kReverse) << "a new episode";
  EXPECT_EQ(avoider.status(now).cycle, 1);
}

// [AVO-6]
TEST_F(InterruptedAvoider, GetsStuckAlsoWithAScannerThatFaultsAgainAndAgain_AVO_6) {
  left = 0.3;
  for (int i = 0; i < 12 * 12 && avoider.state() != AvoiderState::kStuck; ++i) {
    ticks(5);
    badScan();
  }
  tick();
  EXPECT_EQ(avoider.state(), AvoiderState::kStuck) << "[AVO-6]";
  EXPECT_EQ(avoider.status(now).episodes, 1U);
}

// [AVO-3]
TEST_F(InterruptedAvoider, HoldsTheDirectionAndThePhaseOverAFault_AVO_3) {
  left = 0.45, right = 0.4;
  ticks(6);
  ASSERT_EQ(avoider.status(now).turn, 1);
  badScan();
  left = 0.3, right = 0.6;
  EXPECT_EQ(tick(), (avoid::AvoiderCommand{{0.0, 0.7}, false})) << "still to the left [AVO-3]";
  ticks(5);
  EXPECT_EQ(avoider.state(), AvoiderState::kRotate);
  tick();
  EXPECT_EQ(avoider.state(), AvoiderState::kReverse) << "0.8 s of turning in all";
  EXPECT_EQ(avoider.status(now).cycle, 2);
}

// [AVO-6]
TEST_F(InterruptedAvoider, BeginsAnewWhenItWasSwitchedOrTheClockWasSetBackDuringTheFault_AVO_6) {
  left = 0.3;
  for (const bool by_switch : {true, false}) {
    ticks(12 * 12 + 1);
    ASSERT_EQ(avoider.state(), AvoiderState::kStuck);
    badScan();
    if (by_switch) avoider.setEnabled(false, now);
    if (by_switch) avoider.setEnabled(true, now);
    if (!by_switch) now -= std::chrono::seconds(10);
    tick();
    EXPECT_EQ(avoider.state(), AvoiderState::kReverse);
    EXPECT_EQ(avoider.status(now).cycle, 1);
  }
}

// [AVO-4]
TEST_F(InterruptedAvoider, DoesNotBackUpWhereNoBeamLooks_AVO_4) {
  scanner.width = kPi;
  scanner.beams = 181;
  left = 0.3;
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ(tick(), (avoid::AvoiderCommand{{0.0, -0.7}, false})) << "it turns instead [AVO-4]";
  }
  EXPECT_EQ(avoider.status(now).reason, "obstacle ahead, and the scan does not show all that is behind: turning away");
}

// [AVO-4]
TEST_F(InterruptedAvoider, DoesNotBackUpWhereOnlyTheEdgesOfWhatIsBehindAreSeen_AVO_4) {
  left = 0.3;
  for (const double degrees : {240.0, 270.0, 300.0, 345.0}) {
    scanner.width = degrees * kPi / 180.0;
    scanner.beams = static_cast<int>(degrees) + 1;
    for (int i = 0; i < 30; ++i) EXPECT_GE(tick().twist.linear, 0.0) << degrees << " [AVO-4]";
  }
}

// [AVO-4]
TEST_F(InterruptedAvoider, StopsBackingUpWhenNoBeamBehindIsValidAnyMore_AVO_4) {
  left = 0.3;
  EXPECT_LT(tick().twist.linear, 0.0) << "beams that meet nothing look there";
  blind_behind = kPi / 3.0;
  EXPECT_EQ(tick(), (avoid::AvoiderCommand{{0.0, -0.7}, false})) << "[AVO-4]";
}

// [AVO-4]
TEST_F(InterruptedAvoider, StopsBackingUpWhenTheBeamsStraightBehindAreInvalid_AVO_4) {
  left = 0.3;
  blind_behind = 0.05;
  EXPECT_LT(tick().twist.linear, 0.0) << "a hole in which nothing has room";
  blind_behind = 0.15;
  EXPECT_EQ(tick(), (avoid::AvoiderCommand{{0.0, -0.7}, false})) << "[AVO-4]";
}

}  // namespace
}  // namespace frontier_pilot
