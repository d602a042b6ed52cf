#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "frontier_pilot/mapping/mapper.h"
#include "occupancy/octree_layer.h"
#include "thoughtful_correction.h"

namespace frontier_pilot {
namespace {

using test::Thoughtful;

LaserScan2 ringAt(double seconds) {
  LaserScan2 scan;
  scan.stamp = timeFromSeconds(seconds);
  scan.angle_min = -kPi;
  scan.angle_increment = 2.0 * kPi / 180.0;
  scan.range_min = 0.12;
  scan.range_max = 8.0;
  scan.ranges.assign(180, 1.0F);
  return scan;
}

constexpr double kThrough = -0.5 + 30.0 * kPi / 180.0;  ///< direction of the beam that passes the pane [rad]

/// A pane of glass 3 m ahead; one beam shows what is 7 m ahead instead.
LaserScan2 paneAt(double seconds) {
  LaserScan2 scan;
  scan.stamp = timeFromSeconds(seconds);
  scan.angle_min = -0.5;
  scan.angle_increment = kPi / 180.0;
  scan.range_min = 0.12;
  scan.range_max = 10.0;
  for (std::size_t i = 0; i < 58; ++i) scan.ranges.push_back(static_cast<float>(3.0 / std::cos(scan.angle(i))));
  scan.ranges[30] *= 7.0F / 3.0F;
  return scan;
}

class Revisions : public ::testing::Test {
 protected:
  void look(double seconds, const Pose2& T_odom_base) {
    ASSERT_EQ(mapper.insert(ringAt(seconds), T_odom_base, timeFromSeconds(seconds)), mapping::ScanVerdict::kInserted);
  }
  void lookAtThePane(double seconds) {
    ASSERT_EQ(mapper.insert(paneAt(seconds), Pose2(), timeFromSeconds(seconds)), mapping::ScanVerdict::kInserted);
  }
  std::int8_t at(double x, double y) const {
    return mapper.grid().get(mapper.grid().geometry().cellAt({x, y}), kUnknown);
  }

  std::shared_ptr<Thoughtful::Script> script = std::make_shared<Thoughtful::Script>();
  mapping::Mapper mapper{mapping::MapperParameters(), std::make_unique<Thoughtful>(script)};
};

// [MAP-1]
TEST_F(Revisions, ReplaceTheMapAndMoveTheRobotWithIt) {
  look(1.0, Pose2());
  ASSERT_EQ(at(0.0, 0.0), kFree);
  mapper.takeChanges();
  script->T_new_old = Pose2(3.0, 0.0, 0.0);
  const std::uint64_t searched = mapper.generation();
  mapper.reviseNow();
  EXPECT_NE(mapper.generation(), searched) << "a search of the map of before is void";
  EXPECT_EQ(mapper.T_map_odom(), Pose2(3.0, 0.0, 0.0));
  EXPECT_EQ(at(3.0, 0.0), kFree);
  EXPECT_EQ(at(0.0, 0.0), kUnknown) << "nothing is left of what was wrong";
  EXPECT_EQ(mapper.revisions().closures, 2U);
  EXPECT_EQ(mapper.revisions().rendered, 1U);
  EXPECT_EQ(mapper.revisions().last_jump, Pose2(3.0, 0.0, 0.0));
  std::size_t leaves = 0;
  mapper.map().octree().forEach([&](Cell, float) { ++leaves; });
  std::size_t known = 0;
  for (const std::int8_t value : mapper.grid().cells()) known += value == kUnknown ? 0 : 1;
  EXPECT_EQ(leaves, known) << "the octree is the new one, too";
}

// [MAP-2]
TEST_F(Revisions, ReportWhatTheyChangedAndNothingElse) {
  look(1.0, Pose2());
  mapper.takeChanges();
  const OccupancyGrid before = mapper.grid();
  script->T_new_old = Pose2(0.5, 0.0, 0.0);
  mapper.reviseNow();
  ASSERT_TRUE(mapper.grid().geometry() == before.geometry());
  const occupancy::MapChanges changes = mapper.takeChanges();
  EXPECT_FALSE(changes.geometry_changed);
  EXPECT_TRUE(changes.cells == difference(before, mapper.grid()));
  EXPECT_LT(changes.cells.width, before.width() / 2);
}

// [MAP-2]
TEST_F(Revisions, SayThatTheMapHasGrownWhenItHas) {
  look(1.0, Pose2());
  mapper.takeChanges();
  const GridGeometry before = mapper.grid().geometry();
  script->T_new_old = Pose2(25.0, 0.0, 0.0);
  mapper.reviseNow();
  const occupancy::MapChanges changes = mapper.takeChanges();
  EXPECT_TRUE(changes.geometry_changed);
  EXPECT_TRUE(changes.cells == mapper.grid().geometry().rect());
  EXPECT_GT(mapper.grid().width(), before.width);
  EXPECT_TRUE(mapper.grid().geometry().contains(mapper.grid().geometry().cellAt(before.origin)))
      << "it never shrinks: what others know of it stays inside";
}

// [MAP-4]
TEST_F(Revisions, WhoseMapWouldBeTooLargeMoveNeitherTheMapNorTheRobot) {
  look(1.0, Pose2());
  script->T_new_old = Pose2(1250.0, 0.0, 0.0);
  const slam::RevisionWork work = mapper.takeWork();
  look(2.0, Pose2(3.0, 0.0, 0.0));
  slam::MapRevision revision = work();
  ASSERT_TRUE(mapper.revise(revision));
  EXPECT_EQ(mapper.T_map_odom(), Pose2());
  EXPECT_TRUE(revision.closures.empty()) << "nothing is announced";
  EXPECT_EQ(mapper.revisions().rendered, 0U);
  EXPECT_EQ(mapper.revisions().closures, 0U) << "map -> odom jumps with each that is counted";
  look(3.0, Pose2(6.0, 0.0, 0.0));
  EXPECT_EQ(at(0.0, 0.0), kFree);
  EXPECT_EQ(at(3.0, 0.0), kFree);
  EXPECT_EQ(at(6.0, 0.0), kFree) << "later scans land beside the earlier ones";
}

// [MAP-4]
TEST_F(Revisions, SayWhenTheMapWouldBeTooLargeUntilOneFits) {
  look(1.0, Pose2());
  script->T_new_old = Pose2(1250.0, 0.0, 0.0);
  mapper.reviseNow();
  for (int i = 2; i < 10; ++i) look(i, Pose2(0.1 * i, 0.0, 0.0));
  ASSERT_TRUE(mapper.remark(timeFromSeconds(10.0)).has_value());
  EXPECT_EQ(mapper.remark(timeFromSeconds(10.0))->text, "corrected map too large, map and poses stay as they are");
  script->T_new_old = Pose2(2.0, 0.0, 0.0);
  mapper.reviseNow();
  EXPECT_EQ(mapper.T_map_odom(), Pose2(2.0, 0.0, 0.0));
  EXPECT_EQ(mapper.revisions().rendered, 1U);
  for (int i = 20; i < 28; ++i) look(i, Pose2(0.1 * i, 0.0, 0.0));
  EXPECT_FALSE(mapper.remark(timeFromSeconds(28.0)).has_value());
}

// [MAP-4]
TEST_F(Revisions, WhoseMapLeftOutSomethingThatIsMappedAreRefused) {
  look(1.0, Pose2());
  script->T_new_old = Pose2(3.0, 0.0, 0.0);
  script->left_out = 1;
  mapper.reviseNow();
  EXPECT_EQ(mapper.T_map_odom(), Pose2());
  EXPECT_EQ(at(0.0, 0.0), kFree);
  EXPECT_EQ(at(3.0, 0.0), kUnknown);
}

// [MAP-4]
TEST_F(Revisions, MayLeaveOutWhatTheMapHadNoRoomForAnyway) {
  look(1.0, Pose2());
  ASSERT_EQ(mapper.insert(ringAt(2.0), Pose2(1e4, 0.0, 0.0), timeFromSeconds(2.0)), mapping::ScanVerdict::kOutOfBounds);
  script->T_new_old = Pose2(3.0, 0.0, 0.0);
  script->left_out = 1;
  mapper.reviseNow();
  EXPECT_EQ(mapper.T_map_odom(), Pose2(3.0, 0.0, 0.0));
  EXPECT_EQ(at(3.0, 0.0), kFree);
}

TEST_F(Revisions, ThatAreTooLargeAreVoidAfterAResetToo) {
  look(1.0, Pose2());
  script->T_new_old = Pose2(1250.0, 0.0, 0.0);
  const slam::RevisionWork work = mapper.takeWork();
  mapper.reset();
  slam::MapRevision revision = work();
  EXPECT_FALSE(mapper.revise(revision));
  for (int i = 2; i < 10; ++i) look(i, Pose2(0.1 * i, 0.0, 0.0));
  EXPECT_FALSE(mapper.remark(timeFromSeconds(10.0)).has_value());
}

// [MAP-1]
TEST_F(Revisions, PutScansThatCameMeanwhileWhereTheyBelongNow) {
  look(1.0, Pose2());
  script->T_new_old = Pose2(0.0, 4.0, 0.0);
  const slam::RevisionWork work = mapper.takeWork();
  ASSERT_TRUE(work);
  EXPECT_FALSE(mapper.takeWork()) << "one at a time";
  look(2.0, Pose2(6.0, 0.0, 0.0));
  EXPECT_EQ(at(6.0, 0.0), kFree) << "at once where it seems to be";
  slam::MapRevision revision = work();
  ASSERT_TRUE(mapper.revise(revision));
  EXPECT_EQ(at(6.0, 4.0), kFree);
  EXPECT_EQ(at(6.0, 0.0), kUnknown);
  look(3.0, Pose2(9.0, 0.0, 0.0));
  EXPECT_EQ(at(9.0, 4.0), kFree);
}

TEST_F(Revisions, MoveTheRobotWithoutTouchingTheMapWhereNothingElseMoved) {
  look(1.0, Pose2());
  const OccupancyGrid before = mapper.grid();
  script->T_new_old = Pose2(0.01, 0.0, 0.0);
  script->renders = false;
  mapper.reviseNow();
  EXPECT_EQ(mapper.T_map_odom(), Pose2(0.01, 0.0, 0.0));
  EXPECT_TRUE(mapper.grid().cells() == before.cells());
  EXPECT_EQ(mapper.revisions().rendered, 0U);
}

// [MAP-1]
TEST_F(Revisions, DoNotOpenGlassForAScanThatCameMeanwhile) {
  script->T_new_old = Pose2(0.2, 0.0, 0.0);
  const slam::RevisionWork work = mapper.takeWork();
  lookAtThePane(10.0);
  slam::MapRevision revision = work();
  ASSERT_TRUE(mapper.revise(revision));
  EXPECT_EQ(at(2.2, 2.0 * std::tan(kThrough)), kFree) << "before the pane";
  EXPECT_EQ(at(5.2, 5.0 * std::tan(kThrough)), kUnknown) << "it is the same lone return at another pose";
}

// [MAP-1]
TEST_F(Revisions, ThatMoveTheRobotAloneDoNotOpenGlassEither) {
  lookAtThePane(10.0);
  script->T_new_old = Pose2(0.2, 0.0, 0.0);
  script->renders = false;
  mapper.reviseNow();
  lookAtThePane(20.0);
  EXPECT_EQ(at(5.2, 5.0 * std::tan(kThrough)), kUnknown) << "the robot has seen it from one place only";
}

// [FLT-1]
TEST_F(Revisions, ThatFailLeaveTheMapAndMappingGoesOn) {
  look(1.0, Pose2());
  script->T_new_old = Pose2(3.0, 0.0, 0.0);
  const slam::RevisionWork work = mapper.takeWork();
  ASSERT_TRUE(work);
  look(1.5, Pose2(0.5, 0.0, 0.0));
  const OccupancyGrid before = mapper.grid();
  EXPECT_TRUE(mapper.abandonWork());
  EXPECT_TRUE(mapper.grid().cells() == before.cells()) << "with what came while it was out";
  EXPECT_FALSE(mapper.abandonWork()) << "there is none any more";
  EXPECT_EQ(mapper.T_map_odom(), Pose2());
  look(2.0, Pose2(6.0, 0.0, 0.0));
  EXPECT_EQ(at(0.0, 0.0), kFree);
  EXPECT_EQ(at(6.0, 0.0), kFree);
}

TEST_F(Revisions, ThatFailAfterAResetAreNoneOfTheNewMap) {
  look(1.0, Pose2());
  script->T_new_old = Pose2(3.0, 0.0, 0.0);
  ASSERT_TRUE(mapper.takeWork());
  mapper.reset();
  EXPECT_FALSE(mapper.abandonWork());
}

TEST_F(Revisions, AreVoidAfterAReset) {
  look(1.0, Pose2());
  script->T_new_old = Pose2(3.0, 0.0, 0.0);
  const slam::RevisionWork work = mapper.takeWork();
  mapper.reset();
  slam::MapRevision revision = work();
  EXPECT_FALSE(mapper.revise(revision));
  EXPECT_EQ(mapper.T_map_odom(), Pose2());
  EXPECT_EQ(at(3.0, 0.0), kUnknown);
}

}  // namespace
}  // namespace frontier_pilot
