// A robot with bad odometry on a bad day: the map survives, and the diagnostics say what is going on. [MAP-1] [MAP-4]

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "frontier_pilot/mapping/mapper.h"
#include "support/closed_loop/corridor_world.h"
#include "support/closed_loop/faulty_drive.h"

namespace frontier_pilot {
namespace {

struct Outcome {
  std::set<std::string> remarks;  ///< what the mapper's health has said
  Pose2 error;                    ///< at the end, of what the mapper believes
  double usable_share = 0.0;      ///< of the last scan's beams
};

sim::SimulatorParameters badOdometry() {
  sim::SimulatorParameters parameters;
  parameters.odom_noise = true;
  parameters.odometry.alpha1 = parameters.odometry.alpha3 = 0.05 * 0.05;
  parameters.odometry.distance_scale = parameters.odometry.turn_scale = 0.05;
  parameters.robot.limits.max_linear = 0.5;
  parameters.robot.limits.max_angular = 1.5;
  return parameters;
}

Outcome drive(sim::World world, test::SensorFault fault) {
  test::FaultyDrive drive(std::move(world), badOdometry(), 45.0, fault);
  mapping::Mapper mapper;
  Outcome outcome;
  while (const LaserScan2* scan = drive.nextScan()) {
    const auto T_odom_base = drive.T_odom_base();
    mapper.insert(*scan, T_odom_base, scan->stamp);
    mapper.reviseNow();
    if (const auto remark = mapper.remark(scan->stamp)) outcome.remarks.insert(remark->text);
    if (T_odom_base) outcome.error = drive.T_map_base().inverse() * (mapper.T_map_odom() * *T_odom_base);
  }
  outcome.usable_share = mapper.usableShare();
  return outcome;
}

Outcome driveInOffice(test::SensorFault fault) {
  return drive(sim::loadWorld(std::string(WORLDS_DIRECTORY) + "/office.yaml"), fault);
}

void expectTheMapSurvived(const Outcome& outcome) {
  EXPECT_LT(outcome.error.position().norm(), 0.10);
  EXPECT_LT(std::abs(outcome.error.yaw), 0.02);
}

using Remarks = std::set<std::string>;

TEST(SensorFaults, AGoodDayIsNotWorthARemark) {
  const Outcome outcome = driveInOffice(test::SensorFault::kNone);
  expectTheMapSurvived(outcome);
  EXPECT_EQ(outcome.remarks, Remarks{});
}

TEST(SensorFaults, AScannerThatIsCarriedAwayForThreeSecondsDoesNotFitTheMap) {
  const Outcome outcome = driveInOffice(test::SensorFault::kKidnap);
  expectTheMapSurvived(outcome);
  EXPECT_EQ(outcome.remarks, Remarks{"does not fit the map"});
}

TEST(SensorFaults, ThreeBeamsOfTenDroppedAreDoneWithoutAndCounted) {
  const Outcome outcome = driveInOffice(test::SensorFault::kDropout);
  expectTheMapSurvived(outcome);
  EXPECT_NEAR(outcome.usable_share, 0.7, 0.1);
}

TEST(SensorFaults, APersonWhoCrossesLeavesTheMapAsItIs) {
  expectTheMapSurvived(driveInOffice(test::SensorFault::kPerson));
}

TEST(SensorFaults, OdometryThatIsFrozenForASecondIsContradicted) {
  const Outcome outcome = driveInOffice(test::SensorFault::kOdomFrozen);
  expectTheMapSurvived(outcome);
  EXPECT_EQ(outcome.remarks.count("matched, contradicts odometry"), 1U);
}

TEST(SensorFaults, OdometryThatIsMissingForASecondIsMissed) {
  const Outcome outcome = driveInOffice(test::SensorFault::kOdomMissing);
  expectTheMapSurvived(outcome);
  EXPECT_EQ(outcome.remarks.count("no odometry"), 1U);
}

TEST(SensorFaults, AlongACorridorWithoutFeaturesOdometryTellsTheWayAndTheDiagnosticsThatItDoes) {
  const Outcome outcome = drive(test::corridorWorld(), test::SensorFault::kNone);
  EXPECT_EQ(outcome.remarks, Remarks{"matched, position along the walls from odometry"});
  EXPECT_LT(std::abs(outcome.error.x), 0.08 * 33.0) << "what its scale is off by, and no more";
  EXPECT_LT(std::abs(outcome.error.y), 0.10);
  EXPECT_LT(std::abs(outcome.error.yaw), 0.02);
}

}  // namespace
}  // namespace frontier_pilot
