// What every global planner must do, over maps: run for each algorithm. A complete one must also agree with a flood
// fill on whether there is a path at all.

#include <gtest/gtest.h>

#include <cmath>
#include <queue>
#include <random>
#include <string>

#include "frontier_pilot/planning/global_planner.h"
#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

struct Algorithm {
  std::string name;
  bool complete;
};
void PrintTo(const Algorithm& algorithm, std::ostream* out) { *out << algorithm.name; }

class PlannerConformance : public testing::TestWithParam<Algorithm> {
 protected:
  planning::GlobalPlanner planner(double escape_radius = planning::GlobalPlannerParams().escape_radius) const {
    planning::GlobalPlannerParams params;
    params.escape_radius = escape_radius;
    params.algorithm = GetParam().name;
    return planning::GlobalPlanner(params);
  }
};

planning::ClearanceMap clearanceOf(const OccupancyGrid& map) {
  planning::ClearanceMap clearance;
  clearance.setMap(map, map.geometry().rect());
  return clearance;
}

/// Magnifies a drawing, so that a character is `factor` cells wide.
test::AsciiWorld magnified(const std::string& drawing, int factor) {
  const test::AsciiWorld plan = test::drawWorld(drawing);
  GridGeometry geometry = plan.map.geometry();
  geometry.width *= factor;
  geometry.height *= factor;
  test::AsciiWorld world{OccupancyGrid(geometry), {}};
  for (std::size_t i = 0; i < world.map.size(); ++i) {
    const Cell cell = geometry.cell(i);
    world.map[i] = plan.map[Cell{cell.x / factor, cell.y / factor}];
  }
  for (const auto& [mark, cells] : plan.marks) {
    for (const Cell c : cells) world.marks[mark].push_back({c.x * factor + factor / 2, c.y * factor + factor / 2});
  }
  return world;
}

planning::PlanResult planBetween(planning::GlobalPlanner planner, const test::AsciiWorld& world, char from = 'S',
                                 char to = 'G') {
  return planner.plan(clearanceOf(world.map), {world.point(from), world.point(to), -1.0});
}

void expectGoodPath(const planning::ClearanceMap& map, const planning::PlanResult& result, const Vec2& start,
                    const Vec2& goal) {
  ASSERT_TRUE(result.found()) << toString(result.status);
  EXPECT_TRUE(planning::isPathValid(map, result.path, result.escape));
  EXPECT_LT((result.path.points().front() - start).norm(), 1e-9);
  EXPECT_LT((result.path.goal() - goal).norm(), map.geometry().resolution);
}

bool floodReaches(const planning::ClearanceMap& map, Cell from, Cell to) {
  Grid<std::uint8_t> seen(map.geometry(), 0);
  std::queue<Cell> open;
  open.push(from);
  seen[from] = 1;
  while (!open.empty() && open.front() != to) {
    const Cell cell = open.front();
    open.pop();
    for (const Cell step : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
      const Cell next{cell.x + step.x, cell.y + step.y};
      if (!map.isPassable(next) || seen[next] != 0) continue;
      seen[next] = 1;
      open.push(next);
    }
  }
  return !open.empty();
}

const char* const kCorridor = R"(
    ####################
    #S.................#
    ##################.#
    #G.................#
    ####################)";

const char* const kTrap = R"(
    ..............
    .##########...
    ..........#...
    ..........#...
    .S........#.G.
    ..........#...
    ..........#...
    .##########...
    ..............)";

const char* const kMaze = R"(
    #################
    #S#.....#.......#
    #.#.###.#.#####.#
    #.#.#...#.#...#.#
    #.#.#.###.#.#.#.#
    #...#.....#.#...#
    #####.#####.###.#
    #.....#.....#G..#
    #################)";

// [NAV-2]
TEST_P(PlannerConformance, SolvesCorridorTrapAndMaze_NAV_2) {
  for (const char* drawing : {kCorridor, kTrap, kMaze}) {
    const test::AsciiWorld world = magnified(drawing, 12);
    const planning::PlanResult result = planBetween(planner(), world);
    expectGoodPath(clearanceOf(world.map), result, world.point('S'), world.point('G'));
  }
}

TEST_P(PlannerConformance, PassesADoorJustWideEnoughAndNoneJustTooNarrow_NAV_2) {
  // 0.15 m from centre to centre on both sides: five free cells are just wide enough.
  for (int width = 3; width <= 9; ++width) {
    test::AsciiWorld world = magnified("S.G\n...\n...", 20);
    for (int y = 0; y < 60; ++y) {
      if (y < 30 || y >= 30 + width) world.map[Cell{30, y}] = kOccupied;
    }
    const planning::PlanResult result = planBetween(planner(), world);
    if (width < 5) {
      EXPECT_EQ(result.status, planning::PlanStatus::kNoPath) << width;
    }
    if (width >= 5 && GetParam().complete) {
      EXPECT_TRUE(result.found()) << width;
    }
    if (result.found()) {
      EXPECT_TRUE(planning::isPathValid(clearanceOf(world.map), result.path, result.escape));
    }
  }
}

TEST_P(PlannerConformance, GetsOutOfTheInflation_NAV_2) {
  const test::AsciiWorld world = magnified("########\n#......#\n#.....G#\n########", 10);
  const Vec2 start(0.5 + 0.09, 0.7);  // 0.09 m beside the wall's surface
  const planning::ClearanceMap map = clearanceOf(world.map);
  ASSERT_FALSE(map.isValid(start));
  const planning::PlanResult result = planner().plan(map, {start, world.point('G'), -1.0});
  expectGoodPath(map, result, start, world.point('G'));
  EXPECT_GT(result.escape, 0U);
  if (GetParam().complete) {
    EXPECT_LT(result.path.arcLength(result.escape), 0.15) << "straight out";
  }
}

TEST_P(PlannerConformance, LeavesAnIslandThatNoiseHasCutOff_NAV_2) {
  test::AsciiWorld world = magnified("#######\n#S...G#\n#.....#\n#######", 10);
  for (int y = 10; y < 30; ++y) {
    if (y < 18 || y > 21) world.map[Cell{20, y}] = kOccupied;  // a door that the map draws a cell too narrow
  }
  const planning::ClearanceMap map = clearanceOf(world.map);
  const Vec2 near_door(0.85, 1.0);
  const planning::PlanResult result = planner().plan(map, {near_door, world.point('G'), -1.0});
  expectGoodPath(map, result, near_door, world.point('G'));
  EXPECT_GT(result.escape, 0U);
  EXPECT_EQ(planner(0.0).plan(map, {near_door, world.point('G'), -1.0}).status, planning::PlanStatus::kNoPath);
}

TEST_P(PlannerConformance, MovesAGoalInAWallOrInTheUnknownWithinTheTolerance_NAV_2) {
  const test::AsciiWorld world = magnified("#########\n#S..#..??\n#...#..??\n#########", 10);
  const planning::ClearanceMap map = clearanceOf(world.map);
  const Vec2 in_wall(2.0 + 0.1, 0.9);
  const planning::PlanResult near_wall = planner().plan(map, {world.point('S'), in_wall, 0.4});
  ASSERT_TRUE(near_wall.found());
  EXPECT_LE((near_wall.path.goal() - in_wall).norm(), 0.4);
  EXPECT_EQ(planner().plan(map, {world.point('S'), in_wall, 0.1}).status, planning::PlanStatus::kGoalOccupied);
  EXPECT_EQ(planner().plan(map, {world.point('S'), Vec2(4.2, 0.9), 0.4}).status,
            planning::PlanStatus::kGoalUnreachable);
  const planning::PlanResult in_unknown = planner().plan(map, {Vec2(2.8, 0.9), Vec2(3.6, 0.9), 0.4});
  ASSERT_TRUE(in_unknown.found());
  EXPECT_TRUE(map.isValid(in_unknown.path.goal()));
}

TEST_P(PlannerConformance, LooksOnlySoFarAroundAGoal_FLT_1) {  // [FLT-1]
  // 60 m of wall, its middle farther from the floor than any tolerance: the cells within 1e30 m do not fit a number.
  GridGeometry geometry;
  geometry.width = geometry.height = 1200;
  OccupancyGrid map(geometry, kOccupied);
  for (int y = 0; y < 40; ++y) std::fill_n(map.row(y), map.width(), kFree);
  const planning::ClearanceMap clearance = clearanceOf(map);
  for (const double tolerance : {1e30, 1e300, HUGE_VAL}) {
    EXPECT_EQ(planner().plan(clearance, {{1.0, 1.0}, {30.0, 30.0}, tolerance}).status,
              planning::PlanStatus::kGoalOccupied);
    EXPECT_TRUE(planner().plan(clearance, {{20.0, 1.0}, {30.0, 4.0}, tolerance}).found())
        << "within 5 m there is floor";
  }
}

TEST_P(PlannerConformance, NamesWhatIsWrong_NAV_1) {
  const test::AsciiWorld world = magnified("#####\n#S#G#\n#####", 12);
  const planning::ClearanceMap map = clearanceOf(world.map);
  planning::GlobalPlanner planner = this->planner();
  const Vec2 start = world.point('S');
  const double nan = std::nan("");
  EXPECT_EQ(planner.plan(planning::ClearanceMap(), {start, start, -1.0}).status, planning::PlanStatus::kNoMap);
  EXPECT_EQ(planner.plan(map, {start, Vec2(nan, 0.0), -1.0}).status, planning::PlanStatus::kInvalidRequest);
  EXPECT_EQ(planner.plan(map, {Vec2(-1.0, 0.0), start, -1.0}).status, planning::PlanStatus::kStartOutside);
  EXPECT_EQ(planner.plan(map, {start, Vec2(1e12, 0.0), -1.0}).status, planning::PlanStatus::kGoalOutside);
  EXPECT_EQ(planner.plan(map, {start, world.point('G'), -1.0}).status, planning::PlanStatus::kNoPath);
  const test::AsciiWorld solid = magnified("####\n####\n####", 20);
  EXPECT_EQ(planner.plan(clearanceOf(solid.map), {Vec2(2.0, 1.5), Vec2(2.5, 1.5), -1.0}).status,
            planning::PlanStatus::kStartBlocked);
}

TEST_P(PlannerConformance, GivesAPointForAGoalUnderTheRobot_NAV_2) {
  const test::AsciiWorld world = magnified("...\n.S.\n...", 12);
  const planning::PlanResult result = planBetween(planner(), world, 'S', 'S');
  ASSERT_TRUE(result.found());
  EXPECT_LT(result.path.length(), 0.2);
}

// [NAV-2] Found whenever a grid search proves a path; found or not, what is said is true.
TEST_P(PlannerConformance, AgreesWithAFloodFillInRandomWorlds_NAV_2) {
  std::mt19937 random(7);
  // Without escapes: a robot on a small island may leave it where a flood fill may not.
  planning::GlobalPlanner planner = this->planner(0.0);
  const int rounds = GetParam().complete ? 300 : 20;
  int solvable = 0;
  for (int round = 0; round < rounds; ++round) {
    OccupancyGrid map(GridGeometry{0.05, Vec2(1.0, -2.0), 80, 60}, kFree);
    const auto obstacles = 20 + random() % 120;
    for (std::size_t i = 0; i < obstacles; ++i) map[random() % map.size()] = i % 5 == 0 ? kUnknown : kOccupied;
    const planning::ClearanceMap clearance = clearanceOf(map);
    const Cell from = map.geometry().cell(random() % map.size());
    const Cell to = map.geometry().cell(random() % map.size());
    if (!clearance.isPassable(from) || !clearance.isPassable(to)) continue;
    const Vec2 start = map.geometry().centre(from);
    const Vec2 goal = map.geometry().centre(to);
    const planning::PlanResult result = planner.plan(clearance, {start, goal, -1.0});
    const bool reachable = floodReaches(clearance, from, to);
    solvable += reachable ? 1 : 0;
    if (GetParam().complete) {
      EXPECT_EQ(result.found(), reachable) << test::toAscii(map, {{'S', {from}}, {'G', {to}}});
    }
    if (!reachable) {
      EXPECT_EQ(result.status, planning::PlanStatus::kNoPath);
    }
    if (result.found()) expectGoodPath(clearance, result, start, goal);
  }
  EXPECT_GT(solvable, rounds / 10);
}

TEST_P(PlannerConformance, IsNotMuchLongerThanTheStraightLineInTheOpen_NAV_2) {
  if (!GetParam().complete) GTEST_SKIP() << "promises no short paths";
  const test::AsciiWorld world = magnified("..........\n..........\nS.........\n.........G", 20);
  const planning::PlanResult result = planBetween(planner(), world);
  ASSERT_TRUE(result.found());
  EXPECT_LT(result.path.length(), 1.0001 * (world.point('G') - world.point('S')).norm());
}

TEST_P(PlannerConformance, GivesTheSamePathForTheSameQuestion_NAV_2) {
  if (!GetParam().complete) GTEST_SKIP() << "draws from a generator that goes on";
  const test::AsciiWorld world = magnified(kMaze, 12);
  planning::GlobalPlanner used = planner();
  planBetween(planner(), world, 'G', 'S');
  const planning::ClearanceMap map = clearanceOf(world.map);
  used.plan(map, {world.point('G'), world.point('S'), -1.0});
  const planning::PlanRequest request{world.point('S'), world.point('G'), -1.0};
  EXPECT_EQ(used.plan(map, request).path.points(), planner().plan(map, request).path.points());
}

INSTANTIATE_TEST_SUITE_P(All, PlannerConformance,
                         testing::Values(Algorithm{"any_angle_grid", true}, Algorithm{"rrt_connect", false}),
                         [](const auto& algorithm) { return algorithm.param.name; });

}  // namespace
}  // namespace frontier_pilot
