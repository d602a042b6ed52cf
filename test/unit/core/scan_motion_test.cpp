#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kBeams = 360;
constexpr double kPeriod = 0.2;  // [s]
const Twist2 kFast{0.22, 2.8};

LaserScan2 rollingScan(double seconds) {
  LaserScan2 scan;
  scan.stamp = timeFromSeconds(seconds);
  scan.time_increment = kPeriod / kBeams;
  scan.angle_increment = 2.0 * kPi / kBeams;
  scan.range_min = 0.12;
  scan.range_max = 3.5;
  scan.T_base_sensor = Pose2(-0.03, 0.01, 0.4);
  scan.ranges.assign(kBeams, 1.5F);
  return scan;
}

Pose2 poseAt(double seconds) { return integrate(Pose2(1.0, 2.0, 0.5), kFast, seconds); }

/// Odometry every 10 ms from `from` to `to` [s].
PoseTrack trackOf(double from, double to) {
  PoseTrack track;
  for (double t = from; t <= to + 1e-9; t += 0.01) track.add(timeFromSeconds(t), poseAt(t));
  return track;
}

constexpr double kSweep = kPeriod / kBeams * (kBeams - 1);  // [s], from the first measurement to the last

/// Where the end of a beam of a scan that began at `start` really was, in the frame of the base at `reference` [s].
Vec2 trulyMet(std::size_t beam, const LaserScan2& scan, double start, double reference) {
  const std::size_t before = scan.reversed ? kBeams - 1 - beam : beam;
  const Pose2 then = poseAt(start + kPeriod / kBeams * static_cast<double>(before));
  return poseAt(reference).inverse() * (then * scan.T_base_sensor * Vec2(1.5 * direction(scan.angle(beam))));
}

double worstError(const LaserScan2& scan, double start, double reference, double until = 1e9) {
  double worst = 0.0;
  for (std::size_t beam = 0; beam < kBeams; ++beam) {
    if (start + kPeriod / kBeams * static_cast<double>(beam) > until) break;
    worst = std::max(worst, (scan.point(beam, 1.5) - trulyMet(beam, scan, start, reference)).norm());
  }
  return worst;
}

double worstError(const LaserScan2& scan, double start) { return worstError(scan, start, start + kSweep); }

TEST(RollingScan, HasEachBeamWhereTheRobotWasAtItsTime_SCN_1) {  // [SCN-1]
  LaserScan2 scan = rollingScan(1.003);
  EXPECT_GT(worstError(scan, 1.003), 0.5) << "before";
  EXPECT_TRUE(placeBeams(trackOf(0.5, 1.3), ScanReference::kEnd, scan));
  EXPECT_LT(worstError(scan, 1.003), 1e-4);
  EXPECT_NEAR(toSeconds(scan.stamp), 1.003 + kPeriod * (kBeams - 1) / kBeams, 1e-6) << "the time of the last beam";
  EXPECT_EQ(scan.end(), scan.stamp);
  EXPECT_LT((scan.mount(kBeams - 1).position() - scan.T_base_sensor.position()).norm(), 1e-9);
}

TEST(RollingScan, RefersToItsMiddleWhereThatIsWanted_SCN_1) {  // [SCN-1]
  LaserScan2 scan = rollingScan(1.0);
  placeBeams(trackOf(0.5, 1.3), ScanReference::kMiddle, scan);
  EXPECT_NEAR(toSeconds(scan.stamp), 1.1, kPeriod / kBeams);
  LaserScan2 end = rollingScan(1.0);
  placeBeams(trackOf(0.5, 1.3), ScanReference::kEnd, end);
  const Pose2 T_middle_end = poseAt(toSeconds(scan.stamp)).inverse() * poseAt(toSeconds(end.stamp));
  for (std::size_t beam = 0; beam < kBeams; ++beam) {
    EXPECT_LT((scan.point(beam, 1.5) - T_middle_end * end.point(beam, 1.5)).norm(), 1e-4);
  }
}

TEST(RollingScan, IsCorrectedOnlyOnce_SCN_1) {  // [SCN-1]
  const PoseTrack track = trackOf(0.5, 2.0);
  LaserScan2 scan = rollingScan(1.0);
  placeBeams(track, ScanReference::kEnd, scan);
  const LaserScan2 once = scan;
  placeBeams(track, ScanReference::kEnd, scan);
  EXPECT_EQ(scan.stamp, once.stamp);
  EXPECT_EQ(scan.moving_mounts, once.moving_mounts);
}

TEST(RollingScan, ThatIsMeasuredAtOnceStaysAsItIs_SCN_1) {  // [SCN-1]
  LaserScan2 scan = rollingScan(1.0);
  scan.time_increment = 0.0;
  EXPECT_TRUE(placeBeams(trackOf(0.5, 1.3), ScanReference::kEnd, scan));
  EXPECT_EQ(scan.stamp, timeFromSeconds(1.0));
  EXPECT_FALSE(scan.isMoving());
  EXPECT_EQ(scan.mount(7), scan.T_base_sensor);
}

TEST(RollingScan, TakesTheNearestPoseWhereOdometryDoesNotCoverItAndSaysSo_SCN_1) {  // [SCN-1]
  LaserScan2 late = rollingScan(1.0);
  EXPECT_TRUE(placeBeams(trackOf(0.5, 1.15), ScanReference::kEnd, late))
      << "the last message of odometry may be a little older";
  LaserScan2 uncovered = rollingScan(1.0);
  EXPECT_FALSE(placeBeams(trackOf(0.5, 1.05), ScanReference::kEnd, uncovered));
  EXPECT_LT(worstError(uncovered, 1.0), worstError(rollingScan(1.0), 1.0));
  LaserScan2 begun = rollingScan(1.0);
  EXPECT_FALSE(placeBeams(trackOf(1.15, 1.3), ScanReference::kEnd, begun)) << "odometry begins during the scan";
  LaserScan2 nothing = rollingScan(1.0);
  EXPECT_FALSE(placeBeams(PoseTrack(), ScanReference::kEnd, nothing));
  EXPECT_FALSE(nothing.isMoving());
  EXPECT_GT(nothing.stamp, timeFromSeconds(1.19)) << "as if it were measured at its end";
}

TEST(RollingScan, RefersToTheEndOfOdometryIfThatIsOlderThanItsLastBeam_SCN_1) {  // [SCN-1]
  LaserScan2 scan = rollingScan(1.0);
  EXPECT_TRUE(placeBeams(trackOf(0.5, 1.15), ScanReference::kEnd, scan));
  EXPECT_NEAR(toSeconds(scan.stamp), 1.15, 1e-6);
  EXPECT_LT(worstError(scan, 1.0, toSeconds(scan.stamp), 1.15), 1e-4) << "of the beams that odometry covers";
  LaserScan2 later = rollingScan(1.0);
  placeBeams(trackOf(0.5, 0.95), ScanReference::kEnd, later);
  EXPECT_EQ(later.stamp, timeFromSeconds(1.0)) << "not before its first beam";
}

TEST(RollingScan, MayHaveItsLastBeamMeasuredFirst_SCN_1) {  // [SCN-1]
  LaserScan2 scan = rollingScan(1.0);
  scan.reversed = true;
  EXPECT_TRUE(placeBeams(trackOf(0.5, 1.3), ScanReference::kEnd, scan));
  EXPECT_LT(worstError(scan, 1.0), 1e-4);
  EXPECT_LT((scan.mount(0).position() - scan.T_base_sensor.position()).norm(), 1e-9);
}

TEST(RollingScan, ThatIsTooDenseKeepsWhereItsBeamsWereMeasured_FLT_1) {
  LaserScan2 scan = rollingScan(1.0);
  placeBeams(trackOf(0.5, 1.3), ScanReference::kEnd, scan);
  const LaserScan2 third = withAtMost(120, scan);
  ASSERT_EQ(third.moving_mounts.size(), 120U);
  for (std::size_t beam = 0; beam < 120; ++beam) EXPECT_EQ(third.mount(beam), scan.mount(3 * beam));
}

TEST(ScanPlacer, DoesNotDrawABeamAcrossAJumpOfOdometry_SCN_1) {  // [SCN-1]
  ScanPlacer placer{ScannerModel{}};
  for (double t = 0.5; t < 1.1; t += 0.01) placer.addOdometry(timeFromSeconds(t), Pose2());
  for (double t = 1.1; t < 1.3; t += 0.01) placer.addOdometry(timeFromSeconds(t), Pose2(9.0, 0.0, 0.0));
  LaserScan2 scan = rollingScan(1.05);
  placer.place(ScanReference::kEnd, scan);
  for (std::size_t beam = 0; beam < kBeams; ++beam) EXPECT_EQ(scan.mount(beam), scan.T_base_sensor);
}

/// Hands scans with the driver's `increment` [s] to a timing and returns the last one's increment afterwards.
double timed(BeamTiming& timing, double increment) {
  LaserScan2 scan;
  for (int i = 0; i < 6; ++i) {
    scan = rollingScan(kPeriod * i);
    scan.time_increment = increment;
    timing.apply(scan);
  }
  return scan.time_increment;
}

ScannerModel spinningScanner() {
  ScannerModel scanner;
  scanner.rolling = true;
  return scanner;
}

TEST(BeamTiming, BelievesADriverWhoseBeamsFitBetweenTwoScans_SCN_2) {  // [SCN-2]
  BeamTiming timing(spinningScanner());
  EXPECT_EQ(timed(timing, kPeriod / kBeams), kPeriod / kBeams);
  EXPECT_EQ(timing.problem(), "");
  EXPECT_NEAR(timing.period().value(), kPeriod, 1e-9);
}

TEST(BeamTiming, NoticesADriverThatIsWrongAndSaysWhatToSet_SCN_2) {  // [SCN-2]
  for (const double wrong : {1.0 / kBeams, 1.0, 1e30, -0.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
    BeamTiming timing(spinningScanner());
    EXPECT_EQ(timed(timing, wrong), 0.0) << wrong;
    EXPECT_NE(timing.problem().find("set robot/scanner/time_increment, to 0.000556"), std::string::npos)
        << timing.problem();
  }
}

TEST(BeamTiming, NoticesADriverThatGivesNoTimeOfAScannerThatRolls_SCN_2) {  // [SCN-2]
  for (const double none : {0.0, 5e-7, 2.989e-5}) {                         // the last one by the driver of the LDS-01
    BeamTiming rolling(spinningScanner());
    timed(rolling, none);
    EXPECT_NE(rolling.problem().find("take only"), std::string::npos) << rolling.problem();
    EXPECT_NE(rolling.problem().find("by the robot's file the scanner turns (rolling: true)"), std::string::npos)
        << "what the driver contradicts";
    BeamTiming at_once{ScannerModel{}};
    EXPECT_EQ(timed(at_once, none), none);
    EXPECT_EQ(at_once.problem(), "") << "it is described as one that measures all beams at once";
  }
}

TEST(BeamTiming, IsOverriddenForARobot_SCN_2) {  // [SCN-2]
  ScannerModel scanner = spinningScanner();
  scanner.time_increment = 0.0005;
  BeamTiming timing(scanner);
  EXPECT_EQ(timed(timing, 1e30), 0.0005);
  EXPECT_EQ(timing.problem(), "");
  scanner.time_increment = 0.0;
  BeamTiming off(scanner);
  EXPECT_EQ(timed(off, kPeriod / kBeams), 0.0);
}

TEST(BeamTiming, AllowsAScannerThatTurnsAFieldOfViewThatIsNotAFullTurn_SCN_2) {  // [SCN-2]
  BeamTiming timing(spinningScanner());
  for (int i = 0; i < 6; ++i) {
    LaserScan2 scan = rollingScan(kPeriod * i);
    scan.ranges.resize(kBeams / 3);
    timing.apply(scan);
  }
  EXPECT_EQ(timing.problem(), "") << "it measures nothing during two thirds of the turn";
}

TEST(BeamTiming, TakesTheOrderOfTheBeamsFromTheRobot_SCN_2) {  // [SCN-2]
  ScannerModel scanner = spinningScanner();
  scanner.reversed = true;
  LaserScan2 scan = rollingScan(1.0);
  BeamTiming(scanner).apply(scan);
  EXPECT_TRUE(scan.reversed);
}

// Whoever looks up the pose of the robot every few milliseconds of a scan must come to an end.
TEST(BeamTiming, LetsNoScanLastLongerThanASecondWhateverItsStampsSay_FLT_1) {  // [FLT-1]
  constexpr double kYears = 4e8;                                               // [s]
  BeamTiming timing(spinningScanner());
  LaserScan2 scan;
  for (int i = 0; i < 5; ++i) {
    scan = rollingScan(kYears * i);
    scan.time_increment = kYears / kBeams;
    timing.apply(scan);
    EXPECT_LE(toSeconds(scan.end() - scan.stamp), 1.0) << i;
  }
  EXPECT_NE(timing.problem(), "");
  ScannerModel slow;
  slow.time_increment = 0.1;
  BeamTiming fixed(slow);
  EXPECT_EQ(timed(fixed, 0.0), 0.0);
  EXPECT_NE(fixed.problem().find("360 beams would take 36 s"), std::string::npos) << fixed.problem();
}

TEST(BeamTiming, IsNotMisledByALostScanOrAClockThatIsSetBack_SCN_2) {  // [SCN-2]
  BeamTiming timing(spinningScanner());
  timed(timing, kPeriod / kBeams);
  LaserScan2 scan = rollingScan(5.0);
  timing.apply(scan);
  EXPECT_NEAR(timing.period().value(), kPeriod, 1e-9);
  scan = rollingScan(0.0);
  timing.apply(scan);
  EXPECT_FALSE(timing.period());
  EXPECT_EQ(scan.time_increment, kPeriod / kBeams);
}

}  // namespace
}  // namespace frontier_pilot
