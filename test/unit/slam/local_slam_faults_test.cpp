// Faults of sensors and odometry. The drive goes on, the map survives, and the verdicts say what happened.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/drives/tracked_drive.h"

namespace frontier_pilot {
namespace {

using test::TrackedDrive;

constexpr float kNothing = std::numeric_limits<float>::infinity();

bool isBetween(double now, double from, double seconds) { return now >= from && now < from + seconds; }

class LocalSlamFaults : public ::testing::Test {
 protected:
  void run(const TrackedDrive::Fault& fault) { drive.run(test::aroundTheRooms(), scanner, fault); }
  void expectTheMapSurvived(double distance = 0.03, double angle = 0.01) {
    EXPECT_LT(drive.error.position().norm(), distance);
    EXPECT_LT(std::abs(drive.error.yaw), angle);
  }

  test::Scanner scanner{test::rooms(), 0.01};
  TrackedDrive drive;
};

TEST_F(LocalSlamFaults, SurvivesAScannerThatIsCoveredForThreeSeconds) {
  run([](double now, LaserScan2& scan, test::Wheels&) {
    if (isBetween(now, 20.0, 3.0)) scan.ranges.assign(scan.ranges.size(), 0.0F);
    return true;
  });
  EXPECT_EQ(drive.count(slam::MatchVerdict::kTooFew), 30);
  expectTheMapSurvived();
}

TEST_F(LocalSlamFaults, SurvivesAHandBeforeTheScannerForThreeSeconds) {
  run([](double now, LaserScan2& scan, test::Wheels&) {
    if (isBetween(now, 20.0, 3.0)) scan.ranges.assign(scan.ranges.size(), 0.2F);
    return true;
  });
  EXPECT_EQ(drive.count(slam::MatchVerdict::kTooFew) + drive.count(slam::MatchVerdict::kPoor), 30) << "it is small";
  expectTheMapSurvived();
}

TEST_F(LocalSlamFaults, MAP_1_NeverTakesACoveredScannerForOpenGround) {
  for (const float covered : {-kNothing, 0.05F}) {
    TrackedDrive blind;
    blind.run(test::aroundTheRooms(), scanner, [&](double now, LaserScan2& scan, test::Wheels&) {
      if (!isBetween(now, 20.0, 3.0)) return true;
      scan.ranges.assign(scan.ranges.size(), covered);
      for (std::size_t beam = 0; beam < 5; ++beam) scan.ranges[70 * beam] = 0.3F;
      return true;
    });
    EXPECT_EQ(blind.count(slam::MatchVerdict::kCarried), 0) << covered;
    EXPECT_EQ(blind.count(slam::MatchVerdict::kTooFew), 30) << covered;
  }
}

TEST_F(LocalSlamFaults, SurvivesAScannerThatShowsAnotherPlaceForThreeSeconds) {
  test::Scanner elsewhere(test::longCorridor(), 0.01);
  run([&](double now, LaserScan2& scan, test::Wheels&) {
    if (isBetween(now, 20.0, 3.0)) scan = elsewhere.scan({15.0, 1.3, now}, scan.stamp);
    return true;
  });
  EXPECT_GE(drive.count(slam::MatchVerdict::kPoor) + drive.count(slam::MatchVerdict::kAmbiguous), 29);
  expectTheMapSurvived();
}

TEST_F(LocalSlamFaults, FindsItsWayAfterThreeSecondsBlindFromOneRoomIntoAnother) {
  // Blind while it passes each of the doors in turn.
  for (const double from : {8.0, 14.0, 22.0, 28.0}) {
    TrackedDrive blind;
    blind.run(test::aroundTheRooms(), scanner, [&](double now, LaserScan2& scan, test::Wheels&) {
      if (isBetween(now, from, 3.0)) scan.ranges.assign(scan.ranges.size(), 0.0F);
      return true;
    });
    EXPECT_EQ(blind.count(slam::MatchVerdict::kLost), 0) << "blind from " << from << " s";
    EXPECT_LT(blind.error.position().norm(), 0.04) << "blind from " << from << " s";
  }
}

TEST_F(LocalSlamFaults, LosesNothingWithThreeBeamsOfTenDropped) {
  std::mt19937 random(3);
  run([&](double, LaserScan2& scan, test::Wheels&) {
    for (float& range : scan.ranges) {
      if (std::uniform_real_distribution<double>()(random) < 0.3) range = std::nanf("");
    }
    return true;
  });
  EXPECT_LT(drive.worst, 0.04);
  expectTheMapSurvived();
}

TEST_F(LocalSlamFaults, IsNotLedAstrayByAPersonWhoCrosses) {
  // Somebody 0.5 m wide walks by at 1 m/s, 1 m ahead, time and again.
  run([](double now, LaserScan2& scan, test::Wheels&) {
    const double across = std::fmod(now, 4.0) - 2.0;
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const Vec2 beam = direction(scan.angle(i));
      const Vec2 person(1.0, across);
      const double along = beam.dot(person);
      const double inside = 0.25 * 0.25 - person.squaredNorm() + along * along;
      if (along <= 0.0 || inside <= 0.0) continue;
      scan.ranges[i] = std::min(scan.ranges[i], static_cast<float>(along - std::sqrt(inside)));
    }
    return true;
  });
  EXPECT_LT(drive.worst, 0.05);
  expectTheMapSurvived();
}

TEST_F(LocalSlamFaults, FollowsTheRobotWhenOdometryIsFrozenForASecond) {
  run([](double now, LaserScan2&, test::Wheels& wheels) {
    wheels.frozen = isBetween(now, 20.0, 1.0) || isBetween(now, 40.0, 1.0);
    return true;
  });
  EXPECT_LT(drive.worst, 0.06);
  expectTheMapSurvived();
}

TEST_F(LocalSlamFaults, FollowsARobotOfHalfAMetreASecondWhoseOdometryStaysFrozen) {
  drive.run(test::aroundTheRooms(), scanner, [](double, LaserScan2&, test::Wheels& wheels) {
    wheels.frozen = true;
    return true;
  });
  EXPECT_GT(drive.count(slam::MatchVerdict::kContradicts), 50);
  expectTheMapSurvived(0.1, 0.03);
}

TEST_F(LocalSlamFaults, BridgesASecondWithoutScansOrOdometry) {
  run([](double now, LaserScan2&, test::Wheels& wheels) {
    wheels.frozen = isBetween(now, 40.0, 1.0);
    return !isBetween(now, 20.0, 1.0) && !isBetween(now, 40.0, 1.0);
  });
  EXPECT_LT(drive.worst, 0.06);
  expectTheMapSurvived();
}

TEST_F(LocalSlamFaults, LetsOdometryCarryThePlaceAlongACorridorWithoutFeatures) {
  test::Scanner corridor(test::longCorridor(), 0.01);
  corridor.range_max = 5.0;
  drive.run(test::driveAlong({{6.5, 1.4}, {22.0, 1.6}}), corridor);
  EXPECT_EQ(drive.count(slam::MatchVerdict::kPoor), 0);
  // Odometry measures 2 % too much: along the corridor nothing corrects that, across it the pose must stay accurate.
  EXPECT_LT(std::abs(drive.error.x), 0.04 * 15.5);
  EXPECT_LT(std::abs(drive.error.y), 0.05);
  EXPECT_LT(std::abs(drive.error.yaw), 0.01);
}

TEST_F(LocalSlamFaults, StandsStillInACorridorWithoutFeatures) {
  test::Scanner corridor(test::longCorridor(), 0.01);
  corridor.range_max = 5.0;
  drive.run(std::vector<Pose2>(300, Pose2(15.0, 1.4, 0.3)), corridor);
  EXPECT_LT(drive.worst, 0.02);
}

TEST_F(LocalSlamFaults, NoticesThatItIsLostAlsoWhenTheClockWasSetBack) {
  test::Scanner elsewhere(test::longCorridor(), 0.01);
  const std::vector<Pose2> standing(200, Pose2(2.0, 2.0, 0.0));
  drive.run(standing, scanner, [&](double now, LaserScan2& scan, test::Wheels&) {
    if (now > 9.95) scan = elsewhere.scan({4.0, 1.3, 0.0}, scan.stamp - std::chrono::seconds(60));
    return true;
  });
  EXPECT_EQ(drive.count(slam::MatchVerdict::kLost), 1);
}

TEST_F(LocalSlamFaults, BeginsANewMapWhereOdometrySaysWhenNothingFitsForLong) {
  test::Scanner elsewhere(test::longCorridor(), 0.01);
  const std::vector<Pose2> standing(200, Pose2(2.0, 2.0, 0.0));
  drive.run(standing, scanner, [&](double now, LaserScan2& scan, test::Wheels&) {
    if (now > 9.95) scan = elsewhere.scan({4.0, 1.3, 0.0}, scan.stamp);
    return true;
  });
  EXPECT_EQ(drive.count(slam::MatchVerdict::kLost), 1);
  EXPECT_EQ(drive.count(slam::MatchVerdict::kPoor), 50);
  EXPECT_EQ(drive.count(slam::MatchVerdict::kMatched), 148);
}

}  // namespace
}  // namespace frontier_pilot
