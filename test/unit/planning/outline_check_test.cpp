// A robot that is no disc: where its outline fits, and paths that it can follow where its circle would not fit.

#include "frontier_pilot/planning/outline_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/planning/global_planner.h"
#include "support/floors/open_floor.h"
#include "support/floors/zigzag.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

const Outline kWaffle = test::shippedRobot("waffle").drivenOutline();

planning::ClearanceMap laneMap(const OccupancyGrid& map, double radius = kWaffle.halfWidth(),
                               double tight_weight = 10.0) {
  planning::ClearanceParams params;
  params.inscribed_radius = radius;
  params.tight_weight = tight_weight;
  return test::clearanceOf(map, params);
}

/// The distance from the outline of a robot at `pose` to the nearest occupied cell [m], by points all over the cells.
double exactDistance(const OccupancyGrid& map, const Pose2& pose) {
  double least = 10.0;
  const Cell middle = map.geometry().cellAt(pose.position());
  const CellRect near = CellRect{middle.x, middle.y, 1, 1}.grown(10).intersection(map.geometry().rect());
  for (int y = near.y; y < near.y + near.height; ++y) {
    for (int x = near.x; x < near.x + near.width; ++x) {
      if (map[Cell{x, y}] != kOccupied) continue;
      for (int i = 0; i <= 4; ++i) {
        for (int k = 0; k <= 4; ++k) {
          const Vec2 offset = map.resolution() * Vec2(0.25 * i - 0.5, 0.25 * k - 0.5);
          const Vec2 point = map.geometry().centre({x, y}) + offset;
          least = std::min(least, kWaffle.distance(pose.inverse() * point));
        }
      }
    }
  }
  return least;
}

/// The least distance along a path of straight motions and turns on the spot.
double exactDistanceAlong(const OccupancyGrid& map, const planning::Path& path, double yaw) {
  double least = 10.0;
  for (std::size_t i = 0; i + 1 < path.points().size(); ++i) {
    const Vec2 from = path.points()[i];
    const Vec2 to = path.points()[i + 1];
    const double turn = angleDifference(bearing(to - from), yaw);
    for (int k = 0; k <= 30; ++k) least = std::min(least, exactDistance(map, {from, yaw + turn * k / 30}));
    yaw = bearing(to - from);
    for (int k = 0; k <= 30; ++k) least = std::min(least, exactDistance(map, {from + (to - from) * k / 30, yaw}));
  }
  return least;
}

// [ROB-1]
TEST(OutlineChecks, HaveNothingToAddForADisc) {
  EXPECT_TRUE(planning::OutlineCheck().isTrivial());
  EXPECT_TRUE(planning::OutlineCheck(Outline::disc(0.2)).isTrivial());
  EXPECT_FALSE(planning::OutlineCheck(kWaffle).isTrivial());
}

// [ROB-1] [NAV-2]
TEST(OutlineChecks, SeeTheCornersBehindThatSwingOutInATurn) {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 60, 60}, kFree);
  for (int x = 0; x < 60; ++x) map[Cell{x, 20}] = kOccupied;  // its surface is at y = 1.05
  const planning::ClearanceMap clearance = laneMap(map);
  const planning::OutlineCheck check(kWaffle);
  const Vec2 beside(1.5, 1.05 + 0.153 + 0.045);
  EXPECT_TRUE(check.fits(clearance, {beside, 0.0})) << "along the wall";
  EXPECT_FALSE(check.fits(clearance, {beside, 0.5 * kPi})) << "its back would be in the wall";
  EXPECT_FALSE(check.canTurn(clearance, beside, 0.0, 0.5 * kPi));
  EXPECT_TRUE(check.canTurn(clearance, beside + Vec2(0.0, 0.1), 0.0, 0.5 * kPi)) << "0.1 m farther away";
}

// [ROB-1] [NAV-2] The path is one for the outline, not for the circle around it.
TEST(OutlineChecks, LeadThroughTurnsInCorridorsThatTheCircleDoesNotFit) {
  const OccupancyGrid map = test::zigzag(10);  // 0.5 m; the circle has 0.512 m
  const planning::PlanRequest request{{0.7, 0.75}, {5.4, 2.75}, 0.1, 0.0};
  planning::GlobalPlanner for_circle;
  EXPECT_FALSE(for_circle.plan(laneMap(map, kWaffle.circumscribedRadius()), request).found());
  planning::GlobalPlanner planner({}, planning::OutlineCheck(kWaffle));
  const planning::ClearanceMap clearance = laneMap(map);
  const planning::PlanResult result = planner.plan(clearance, request);
  ASSERT_TRUE(result.found()) << toString(result.status);
  EXPECT_TRUE(planning::isPathValid(clearance, result.path, result.escape));
  EXPECT_TRUE(planning::OutlineCheck(kWaffle).inTightPlaces().canFollow(clearance, result.path, result.escape, 0.0,
                                                                        Pose2(request.start, 0.0)));
  EXPECT_GT(exactDistanceAlong(map, result.path, 0.0), -0.005) << "the scan decides about the rest";
  EXPECT_LT(result.path.length(), 6.7);
}

TEST(OutlineChecks, RefuseATurnThatTheOutlineDoesNotFit) {
  const OccupancyGrid map = test::zigzag(8);  // 0.40 m: it fits straight on, and cannot turn
  planning::GlobalPlanner planner({}, planning::OutlineCheck(kWaffle));
  const planning::ClearanceMap clearance = laneMap(map);
  EXPECT_TRUE(planner.plan(clearance, {{0.7, 0.7}, {2.0, 0.7}, 0.0, 0.0}).found());
  EXPECT_EQ(planner.plan(clearance, {{0.7, 0.7}, {5.4, 2.8}, 0.0, 0.0}).status, planning::PlanStatus::kStartBlocked)
      << "it might help to back up to where there is more room";
}

// [NAV-2] A goal at the end of a lane that the robot could only turn into if it were shorter.
TEST(OutlineChecks, AreSearchedForWithinALimitThatHoldsForTheWholePlan) {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 400, 400}, kFree);
  for (int y = 300; y < 400; ++y) {
    for (int x = 0; x < 400; ++x) map[Cell{x, y}] = kOccupied;
  }
  for (int y = 290; y < 340; ++y) {
    for (int x = 200; x < 208; ++x) map[Cell{x, y}] = kFree;
  }
  for (int x = 200; x < 260; ++x) {
    for (int y = 332; y < 340; ++y) map[Cell{x, y}] = kFree;  // round a corner
  }
  planning::GlobalPlanner planner({}, planning::OutlineCheck(kWaffle));
  planning::PlanRequest request{{2.0, 2.0}, {12.0, 16.8}, 0.0, 0.0};
  const planning::PlanResult result = planner.plan(laneMap(map), request);
  EXPECT_FALSE(result.found());
  EXPECT_GT(result.expanded, bounds::kMostOrientedStates) << "otherwise this tests nothing";
  EXPECT_LT(result.expanded, 2 * bounds::kMostOrientedStates + 200'000) << "with the cells of the path for the lane";
}

// [NAV-2] A law, on random floors without tight places: what is found can be followed, and nothing is touched.
TEST(OutlineChecks, HoldForEveryPathThatIsFound) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> any(0, 99);
  int found = 0;
  int oriented = 0;
  for (int round = 0; round < 40; ++round) {
    OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 100, 100}, kFree);
    for (int i = 0; i < 45; ++i) map[Cell{any(random), any(random)}] = kOccupied;
    const planning::ClearanceMap clearance = laneMap(map, kWaffle.halfWidth(), 0.0);
    const planning::OutlineCheck check(kWaffle);
    const Pose2 start(0.5, 0.5, 0.06 * any(random));
    if (!clearance.isValid(start.position()) || !check.fits(clearance, start)) continue;
    const planning::PlanRequest request{start.position(), {4.5, 4.5}, 0.3, start.yaw};
    const planning::PlanResult lane = planning::GlobalPlanner().plan(clearance, request);
    const planning::PlanResult result = planning::GlobalPlanner({}, check).plan(clearance, request);
    if (!result.found()) continue;
    ++found;
    oriented += check.canFollow(clearance, lane.path, lane.escape, 0.0, start) ? 0 : 1;
    EXPECT_TRUE(planning::isPathValid(clearance, result.path, result.escape)) << round;
    EXPECT_GT(exactDistanceAlong(map, result.path, start.yaw), 0.0) << round;
  }
  EXPECT_GT(found, 15);
  EXPECT_GT(oriented, 3) << "the shortest path for the lane is not always one for the outline";
}

// [NAV-2] The map tells clearances up to 0.4 m, and this robot reaches half a metre far.
TEST(OutlineChecks, ALargeRobotCanTurnRoundInTheOpenAndNotBesideAnObstacle_NAV_2) {
  const Outline outline = Outline::polygon({{0.4, 0.3}, {-0.4, 0.3}, {-0.4, -0.3}, {0.4, -0.3}});
  const planning::OutlineCheck check(outline);
  const OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 100, 100}, kFree);
  const Vec2 middle = map.geometry().centre({50, 50});
  EXPECT_TRUE(check.canTurnRound(laneMap(map, outline.halfWidth()), middle));
  for (const double distance : {0.3, 0.45, 0.5}) {
    OccupancyGrid furnished = map;
    furnished[map.geometry().cellAt(middle + distance * Vec2(0.8, 0.6))] = kOccupied;
    EXPECT_FALSE(check.canTurnRound(laneMap(furnished, outline.halfWidth()), middle)) << distance;
  }
}

}  // namespace
}  // namespace frontier_pilot
