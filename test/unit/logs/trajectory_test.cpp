#include "frontier_pilot/logs/trajectory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "frontier_pilot/logs/scan_log.h"

namespace frontier_pilot {
namespace {

const std::vector<Pose2> kSquare = {{0, 0, 0}, {2, 0, kPi / 2}, {2, 2, kPi}, {0, 2, -kPi / 2}};

std::vector<logs::PoseRelation> relationsOf(const std::string& text, std::size_t records) {
  std::istringstream file(text);
  return logs::readRelations(file, "drive.relations", records);
}

std::string problemOfRelations(const std::string& text) {
  try {
    relationsOf(text, 10);
  } catch (const logs::LogError& error) {
    return error.what();
  }
  return "none";
}

std::vector<Pose2> moved(const std::vector<Pose2>& poses, const Pose2& by) {
  std::vector<Pose2> out;
  for (const Pose2& pose : poses) out.push_back(by * pose);
  return out;
}

TEST(Tum, HasALineForEachPose) {
  std::ostringstream out;
  logs::writeTum(out, {{timeFromSeconds(1.5), {1.0, -2.0, kPi / 2}}, {timeFromSeconds(2.0), {}}});
  EXPECT_EQ(
      out.str(),
      "1.500000 1.000000 -2.000000 0 0 0 0.707107 0.707107\n2.000000 0.000000 0.000000 0 0 0 0.000000 1.000000\n");
}

TEST(Relations, AreReadAsPosesBetweenRecords) {
  const auto relations = relationsOf("# i j dx dy dyaw\n0 50 3.607 -8.389 -1.4575\n\n9 3 0 0 3\n", 51);
  ASSERT_EQ(relations.size(), 2U);
  EXPECT_EQ(relations[0].to, 50U);
  EXPECT_EQ(relations[0].T_from_to, Pose2(3.607, -8.389, -1.4575));
  EXPECT_EQ(relations[1].from, 9U);
}

TEST(Relations, SayInWhichLineWhatIsBroken) {
  EXPECT_EQ(problemOfRelations("0 1 2 3\n"), "drive.relations:1: ends where dyaw should be");
  EXPECT_EQ(problemOfRelations("0 1 2 3 4 5\n"), "drive.relations:1: has more than five values");
  EXPECT_EQ(problemOfRelations("0 1 2 3 4\n-1 1 2 3 4\n"),
            "drive.relations:2: the first record is not a whole number: '-1'");
  EXPECT_EQ(problemOfRelations("0 10 2 3 4\n"), "drive.relations:1: record 10 is beyond the log's end");
  EXPECT_EQ(problemOfRelations(""), "drive.relations: holds no relation");
}

TEST(RelationError, IsZeroForTheTruthWhereverItLies) {
  const std::vector<logs::PoseRelation> relations = {{0, 1, {2, 0, kPi / 2}}, {1, 3, {2, 2, kPi}}};
  const logs::RelationError error = logs::relationError(moved(kSquare, {5.0, -1.0, 0.7}), relations);
  EXPECT_NEAR(error.translation.mean, 0.0, 1e-12);
  EXPECT_NEAR(error.rotation.mean, 0.0, 1e-12);
}

TEST(RelationError, IsMeanAndDeviationOfLengthsAndAngles) {
  const std::vector<logs::PoseRelation> relations = {{0, 1, {1.7, 0.4, kPi / 2 + 0.1}}, {1, 2, {2, 0, kPi / 2 - 0.3}}};
  const logs::RelationError error = logs::relationError(kSquare, relations);
  EXPECT_NEAR(error.translation.mean, 0.25, 1e-12);
  EXPECT_NEAR(error.translation.stddev, 0.25, 1e-12);
  EXPECT_NEAR(error.rotation.mean, 0.2, 1e-12);
  EXPECT_NEAR(error.rotation.stddev, 0.1, 1e-12);
}

TEST(AbsoluteError, LaysTheTrajectoriesUponEachOtherAtTheStart) {
  const logs::AbsoluteError error = logs::absoluteError(moved(kSquare, {5.0, -1.0, 0.7}), kSquare);
  EXPECT_NEAR(error.position_max, 0.0, 1e-12);
  EXPECT_NEAR(error.yaw_max, 0.0, 1e-12);
}

TEST(AbsoluteError, IsRootOfTheMeanSquareAndTheLargest) {
  std::vector<Pose2> estimate = kSquare;
  estimate[1].x += 0.3;
  estimate[2].y -= 0.4;
  estimate[3].yaw += 0.2;
  const logs::AbsoluteError error = logs::absoluteError(estimate, kSquare);
  EXPECT_NEAR(error.position_rmse, 0.25, 1e-12);
  EXPECT_NEAR(error.position_max, 0.4, 1e-12);
  EXPECT_NEAR(error.yaw_rmse, 0.1, 1e-12);
  EXPECT_NEAR(error.yaw_max, 0.2, 1e-12);
  EXPECT_EQ(logs::absoluteError({}, {}).position_rmse, 0.0);
}

}  // namespace
}  // namespace frontier_pilot
