#include "frontier_pilot/occupancy/scan_inserter.h"

#include <gtest/gtest.h>

#include "support/ascii_world.h"
#include "support/drives/drive.h"

namespace frontier_pilot {
namespace {

using test::AsciiWorld;
using test::drawWorld;
using test::Scanner;

// 0.25 m a character: each is made of 5 x 5 cells of the map.
constexpr int kFine = 5;

AsciiWorld asciiRoom() {
  return drawWorld(R"(
    ########################
    #......................#
    #......................#
    #....##..........#.....#
    #....##.........##.....#
    #..............##......#
    #......................#
    #......#...............#
    #......#.......#########
    #......#...............#
    #......................#
    ########################
  )",
                   0.25);
}

OccupancyGrid refine(const OccupancyGrid& coarse) {
  GridGeometry geometry = coarse.geometry();
  geometry.resolution /= kFine;
  geometry.width *= kFine;
  geometry.height *= kFine;
  OccupancyGrid fine(geometry);
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const Cell cell = geometry.cell(i);
    fine[i] = coarse[Cell{cell.x / kFine, cell.y / kFine}];
  }
  return fine;
}

Grid<std::uint8_t> solidOf(const OccupancyGrid& map) {
  Grid<std::uint8_t> solid(map.geometry());
  for (std::size_t i = 0; i < map.size(); ++i) solid[i] = map[i] == kFree ? 0 : 1;
  return solid;
}

/// Two turns along a rectangle in the room, in 2 cm steps, scanning in each.
std::vector<Pose2> rounds() {
  std::vector<Pose2> poses;
  const std::vector<Vec2> corners = {{0.6, 0.37}, {3.4, 0.37}, {3.4, 1.37}, {5.4, 1.37},
                                     {5.4, 2.6},  {0.6, 2.6},  {0.6, 0.37}};
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      const Vec2 leg = corners[i + 1] - corners[i];
      const int steps = static_cast<int>(leg.norm() / 0.02);
      for (int k = 0; k < steps; ++k) poses.emplace_back(corners[i] + leg * k / steps, bearing(leg));
    }
  }
  return poses;
}

bool hasFreeNeighbour(const OccupancyGrid& map, Cell c) {
  return map.get({c.x + 1, c.y}, kUnknown) == kFree || map.get({c.x - 1, c.y}, kUnknown) == kFree ||
         map.get({c.x, c.y + 1}, kUnknown) == kFree || map.get({c.x, c.y - 1}, kUnknown) == kFree;
}

/// The room's convex corners: the hit of a beam that just clips one comes to lie in the free cell behind it.
constexpr int kCorners = 13;

struct Comparison {
  int unseen = 0;   ///< free in truth, unknown on the map
  int phantom = 0;  ///< free in truth, occupied on the map
  int holes = 0;    ///< a wall's surface, free or unknown on the map
};

Comparison compare(const OccupancyGrid& truth, const occupancy::OccupancyMap& map) {
  Comparison result;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Cell cell = truth.geometry().cell(i);
    const std::int8_t mapped = map.grid().get(map.geometry().cellAt(truth.geometry().centre(cell)), kUnknown);
    if (truth[i] == kFree) {
      result.unseen += isUnknown(mapped) ? 1 : 0;
      result.phantom += isOccupied(mapped) ? 1 : 0;
    } else if (hasFreeNeighbour(truth, cell)) {
      result.holes += isOccupied(mapped) ? 0 : 1;
    }
  }
  return result;
}

class DriveThroughARoom : public ::testing::Test {
 protected:
  Comparison drive(double noise, const occupancy::ScanInsertionParameters& parameters = {}, double lost_share = 0.0) {
    const OccupancyGrid truth = refine(asciiRoom().map);
    Scanner scanner(solidOf(truth), noise);
    scanner.lost_share = lost_share;
    occupancy::ScanInserter inserter(parameters);
    map = occupancy::OccupancyMap();
    for (const Pose2& pose : rounds()) {
      if (inserter.insert(surfaces::readScan(scanner.scan(pose, Time{})), pose, map) != occupancy::Insertion::kInserted)
        ADD_FAILURE();
    }
    return compare(truth, map);
  }
  /// The map where the room is.
  std::string drawing() const {
    const GridGeometry geometry = refine(asciiRoom().map).geometry();
    OccupancyGrid part(geometry);
    for (std::size_t i = 0; i < part.size(); ++i) {
      part[i] = map.grid().get(map.geometry().cellAt(geometry.centre(geometry.cell(i))), kUnknown);
    }
    return "the map:\n" + test::toAscii(part);
  }

  occupancy::OccupancyMap map;
};

TEST_F(DriveThroughARoom, GivesTheRoomWithoutNoise) {
  const Comparison result = drive(0.0);
  EXPECT_EQ(result.unseen, 0) << drawing();
  EXPECT_LE(result.phantom, kCorners) << drawing();
  EXPECT_EQ(result.holes, 0) << drawing();
}

TEST_F(DriveThroughARoom, LeavesNoHoleInAWallAndNoCellBeforeOneUnknownUnderRangeNoise) {
  const Comparison result = drive(0.01);
  EXPECT_EQ(result.unseen, 0) << drawing();
  EXPECT_LE(result.phantom, kCorners) << drawing();
  EXPECT_EQ(result.holes, 0) << drawing();
}

TEST_F(DriveThroughARoom, PutsHalfOfTheSurfaceIntoTheFreeCellsWithoutTheOffset) {
  occupancy::ScanInsertionParameters parameters;
  parameters.hit_offset = 0.0;
  EXPECT_GT(drive(0.01, parameters).phantom, 100) << "or the offset is not needed any more";
}

TEST_F(DriveThroughARoom, KeepsItsWallsThoughSomeBeamsGetLostAtThem) {
  const Comparison result = drive(0.01, {}, 0.1);
  EXPECT_EQ(result.holes, 0) << drawing();
}

surfaces::SurfaceScan oneBeam(float range, double range_max = 8.0, const Pose2& T_base_sensor = {}) {
  LaserScan2 scan;
  scan.angle_increment = 0.1;
  scan.range_min = 0.12;
  scan.range_max = range_max;
  scan.T_base_sensor = T_base_sensor;
  scan.ranges = {range};
  return surfaces::readScan(scan);
}

std::int8_t valueAt(const occupancy::OccupancyMap& map, double x, double y) {
  return map.grid().get(map.geometry().cellAt({x, y}), kUnknown);
}

occupancy::ScanInsertionParameters withoutFootprint() {
  occupancy::ScanInsertionParameters parameters;
  parameters.robot_radius = 0.0;
  return parameters;
}

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(ScanInserter, ClearsUpToTheSurfaceAndMarksIt) {
  occupancy::OccupancyMap map;
  ASSERT_EQ(occupancy::ScanInserter().insert(oneBeam(1.0F), Pose2(0.0, 0.026, 0.0), map),
            occupancy::Insertion::kInserted);
  EXPECT_EQ(valueAt(map, 0.52, 0.026), kFree);
  EXPECT_EQ(valueAt(map, 0.98, 0.026), kFree);
  EXPECT_EQ(valueAt(map, 1.02, 0.026), kOccupied);
  EXPECT_EQ(valueAt(map, 1.07, 0.026), kUnknown);
}

TEST(ScanInserter, KeepsAWallWhereItIsHoweverFlatItIsSeenAndIfThePoseIsOffByALittle_MAP_2) {
  // Down the middle of a corridor of 0.6 m: nearly every beam meets a wall at a flat angle.
  Grid<std::uint8_t> solid(GridGeometry{0.05, Vec2::Zero(), 240, 20}, 1);
  test::fill(solid, {4, 4, 232, 12}, 0);
  Scanner scanner(solid, 0.01);
  occupancy::OccupancyMap map;
  occupancy::ScanInserter inserter;
  for (int i = 0; i < 200; ++i) {
    const Pose2 pose(1.0 + 0.05 * i, 0.5, 0.01 * i);
    const Pose2 estimate(pose.x, pose.y + (i % 2 == 0 ? 0.012 : -0.012), pose.yaw);
    inserter.insert(surfaces::readScan(scanner.scan(pose, Time{})), estimate, map);
  }
  int wide = 0;
  int holes = 0;
  for (double x = 1.025; x < 11.0; x += 0.05) {
    for (const double y : {0.225, 0.775}) wide += valueAt(map, x, y) == kFree ? 0 : 1;
    for (const double y : {0.175, 0.825}) holes += valueAt(map, x, y) == kOccupied ? 0 : 1;
  }
  EXPECT_LT(wide, 10) << "of 400 cells beside a wall";
  EXPECT_LT(holes, 10) << "of 400 cells of a wall";
}

// [MAP-2] beams without a return clear free space
TEST(ScanInserter, ClearsAlongABeamWithoutReturnUpToTheLimit_MAP_2) {
  occupancy::ScanInsertionParameters parameters;
  parameters.max_clear_range = 3.0;
  occupancy::OccupancyMap map;
  ASSERT_EQ(occupancy::ScanInserter(parameters).insert(oneBeam(kInfinity), Pose2(0.0, 0.026, 0.0), map),
            occupancy::Insertion::kInserted);
  EXPECT_EQ(valueAt(map, 2.93, 0.026), kFree);
  EXPECT_EQ(valueAt(map, 3.08, 0.026), kUnknown);
  occupancy::OccupancyMap short_sighted;
  ASSERT_EQ(occupancy::ScanInserter().insert(oneBeam(kInfinity, 2.0), Pose2(0.0, 0.026, 0.0), short_sighted),
            occupancy::Insertion::kInserted);
  EXPECT_EQ(valueAt(short_sighted, 1.93, 0.026), kFree);
  EXPECT_EQ(valueAt(short_sighted, 2.08, 0.026), kUnknown) << "never beyond the scanner's own range";
}

// [MAP-4] [AVO-2]
TEST(ScanInserter, LearnsNothingFromInvalidAndTooNearBeams_MAP_4) {
  for (const float range : {0.0F, std::nanf(""), -1.0F, 0.05F, -kInfinity}) {
    occupancy::OccupancyMap map;
    EXPECT_EQ(occupancy::ScanInserter(withoutFootprint()).insert(oneBeam(range), Pose2(), map),
              occupancy::Insertion::kAllInvalid);
    EXPECT_TRUE(map.grid().empty());
  }
}

TEST(ScanInserter, ClearsWhereTheRobotStands) {
  occupancy::OccupancyMap map;
  ASSERT_EQ(occupancy::ScanInserter().insert(oneBeam(1.0F), Pose2(3.0, 2.0, 0.5), map),
            occupancy::Insertion::kInserted);
  for (int i = 0; i < 60; ++i) {
    const Vec2 point = Vec2(3.0, 2.0) + 0.06 * direction(0.1 * i);
    EXPECT_EQ(valueAt(map, point.x(), point.y()), kFree);
  }
}

TEST(ScanInserter, KnowsWhereTheScannerSits) {
  const surfaces::SurfaceScan scan = oneBeam(1.0F, 8.0, Pose2(0.0, 1.0, kPi / 2.0));
  occupancy::OccupancyMap map;
  // Base at (5, 5) looking along -x: the scanner is at (5, 4), looking along -y.
  ASSERT_EQ(occupancy::ScanInserter().insert(scan, Pose2(5.026, 5.0, kPi), map), occupancy::Insertion::kInserted);
  EXPECT_EQ(valueAt(map, 5.026, 3.52), kFree);
  EXPECT_EQ(valueAt(map, 5.026, 2.98), kOccupied);
}

TEST(ScanInserter, TakesAnObstacleThatHasGoneOffTheMap) {
  occupancy::OccupancyMap map;
  occupancy::ScanInserter inserter;
  for (int i = 0; i < 50; ++i) inserter.insert(oneBeam(2.0F), Pose2(0.0, 0.026, 0.0), map);
  ASSERT_EQ(valueAt(map, 2.02, 0.026), kOccupied);
  for (int i = 0; i < 10; ++i) inserter.insert(oneBeam(kInfinity), Pose2(0.0, 0.026, 0.0), map);
  EXPECT_EQ(valueAt(map, 2.02, 0.026), kFree);
  EXPECT_EQ(valueAt(map, 4.02, 0.026), kFree);
}

TEST(ScanInserter, DoesNotLookBehindAKnownWallWhenABeamGetsLost) {
  occupancy::OccupancyMap map;
  occupancy::ScanInserter inserter;
  for (int i = 0; i < 50; ++i) inserter.insert(oneBeam(2.0F), Pose2(0.0, 0.026, 0.0), map);
  inserter.insert(oneBeam(kInfinity), Pose2(0.0, 0.026, 0.0), map);
  EXPECT_EQ(valueAt(map, 2.02, 0.026), kOccupied);
  EXPECT_EQ(valueAt(map, 2.12, 0.026), kUnknown);
}

// [MAP-4]
TEST(ScanInserter, LeavesTheMapAloneWhenItWouldGetTooLarge_MAP_4) {
  occupancy::OccupancyMap map;
  occupancy::ScanInserter inserter;
  ASSERT_EQ(inserter.insert(oneBeam(1.0F), Pose2(), map), occupancy::Insertion::kInserted);
  const auto before = map.grid().cells();
  EXPECT_EQ(inserter.insert(oneBeam(1.0F), Pose2(1e5, 0.0, 0.0), map), occupancy::Insertion::kOutOfBounds);
  EXPECT_TRUE(map.grid().cells() == before);
}

TEST(ScanInserter, RendersTheSameScansToTheSameMap) {
  const OccupancyGrid truth = refine(asciiRoom().map);
  occupancy::OccupancyMap first;
  occupancy::OccupancyMap again;
  for (occupancy::OccupancyMap* map : {&first, &again}) {
    Scanner scanner(solidOf(truth), 0.01);
    occupancy::ScanInserter inserter;
    for (int pass = 0; pass < (map == &again ? 2 : 1); ++pass) {
      if (pass == 1) map->clear();
      scanner = Scanner(solidOf(truth), 0.01);
      for (const Pose2& pose : rounds()) inserter.insert(surfaces::readScan(scanner.scan(pose, Time{})), pose, *map);
    }
  }
  EXPECT_TRUE(first.grid().cells() == again.grid().cells())
      << "also after a clear: this is how a correction is rendered";
}

}  // namespace
}  // namespace frontier_pilot
