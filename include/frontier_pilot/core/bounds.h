#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

/// The bounds of every number from outside that sizes memory or work, in one place. What lies beyond is refused by name
/// and counted. docs/limits.md has the same as a table, for operators. [FLT-1]
namespace frontier_pilot::bounds {

/// Coordinates of poses [m]. A robot on wheels stays far within, and at the finest resolution the cells that lie so far
/// away, and a few such distances added up, still have numbers that an int holds.
constexpr double kMostCoordinate = 1e6;
/// Speeds that odometry may report [m/s, rad/s]: what it is extrapolated with must stay near.
constexpr double kMostSpeed = 100.0;

/// Odometry that is kept for finding the pose at a stamp: 1 kHz for five seconds.
constexpr std::size_t kMostOdometry = 5000;

/// From the base to a sensor on it [m]. The largest vehicles are as long; what is farther away is not mounted on it.
constexpr double kMostMount = 10.0;
/// Beams of a scan: a whole turn in steps of a hundredth of a degree. Scanners have up to a few thousand.
constexpr std::size_t kMostRanges = 36000;
/// Beams of a scan that the mapper uses, evenly spread: in steps of 0.05 degrees neighbours meet the same cell of 5 cm
/// up to 57 m away.
constexpr std::size_t kMostMappedBeams = 7200;
/// The angle between beams, at least [rad]: a tenth of the step above. It divides.
constexpr double kLeastAngleIncrement = 1.7e-5;
/// The first and the last angle of a scan, either way [rad]: drivers count from -pi, from 0, or a turn on.
constexpr double kMostAngle = 12.6;
/// A scanner's range [m]: none sees farther.
constexpr double kMostRange = 1000.0;
/// What of that is used [m]: beams that end farther away count as free up to here. A map has sides of 200 m.
constexpr double kUsedRange = 100.0;

/// Side of a map's cell [m]. Distances are divided by it, so that it sizes windows of cells around the robot: 1 cm is
/// finer than any scanner can tell, 10 m wider than any robot that drives by it.
constexpr double kLeastResolution = 0.01;
constexpr double kMostResolution = 10.0;
/// Cells along a side of a map: one kilometre at 5 cm.
constexpr int kMostSide = 20000;
/// Cells of a map that a node takes: 5000 x 5000. The navigator keeps 14 bytes for each, and takes 18 for a moment.
constexpr std::size_t kMostMapCells = 25'000'000;

/// Cells of a map's frontier that the explorer sorts into clusters: a building of 250 m x 250 m that is known in
/// patches has 1.2 million, noise six times as many.
constexpr std::size_t kMostFrontierCells = 2'000'000;
/// Clusters of them. That building has 60,000, most of them too small to be driven to.
constexpr std::size_t kMostFrontiers = 100'000;
/// Those of them within reach that a goal is looked for, at each decision: each costs a quarter of a millisecond.
constexpr std::size_t kMostJudgedFrontiers = 4000;

/// Poses of a path.
constexpr std::size_t kMostPathPoses = 100'000;
/// How far from the goal a plan may end [m]: all cells within are looked at.
constexpr double kMostGoalTolerance = 5.0;
/// Cells around the goal that a plan may end in, the nearest ones.
constexpr std::size_t kMostGoalCells = 10'000;

/// States of position and direction that a path for a robot that is no disc is looked for in: a second of work.
constexpr std::size_t kMostOrientedStates = 200'000;

/// Obstacles in the simulated world, and their radius [m]: each is filed in every square of 2 m that it touches.
constexpr std::size_t kMostObstacles = 1000;
constexpr double kMostObstacleRadius = 10.0;
/// Characters of a name that is kept: of an obstacle, of a source, of a frame.
constexpr std::size_t kMostName = 256;

/// Frames in TF: each is kept for as long as the node lives.
constexpr std::size_t kMostFrames = 1000;
/// Characters of a goal's id, which is kept and published. Those that actionlib makes hold a node's name, a count and a
/// time.
constexpr std::size_t kMostGoalId = 1024;
/// Goals of an action that have ended, or were cancelled without being known.
constexpr std::size_t kMostTrackedGoals = 64;

/// Updates of a map that are kept for a whole map that arrives late, and their cells: 16 MB, five minutes of the
/// mapper.
constexpr std::size_t kMostRecentUpdates = 2000;
constexpr std::size_t kMostRecentCells = std::size_t{1} << 24;

/// A world's image: its bytes, its pixels (8000 x 8000), and what a pixel and a side of it may measure [m]. They size
/// grids, and an index for casting rays.
constexpr std::size_t kMostImageBytes = 300'000'000;
constexpr std::uint64_t kMostPixels = 64'000'000;
constexpr double kLeastPixelSize = 0.001;
constexpr double kMostPixelSize = 1.0;
constexpr double kMostWorldSide = 5000.0;
constexpr double kMostWorldOrigin = 1e5;

/// A YAML file: its bytes, its values, and how deep they are nested. Aliases make more values of a few lines than
/// memory holds.
constexpr std::size_t kMostYamlBytes = 1'000'000;
constexpr int kMostYamlValues = 100'000;
constexpr int kMostYamlDepth = 32;

/// Characters of a reason for a refusal, and different ones that are counted apart: they quote what came in.
constexpr std::size_t kMostReason = 256;
constexpr std::size_t kMostReasons = 32;
/// Bytes of a line of the log, and of a text in the diagnostics.
constexpr std::size_t kMostLine = 500;
constexpr std::size_t kMostDiagnostic = 2000;

/// Bytes of a status that the window shows, and services that it watches because a status named their source.
constexpr unsigned kMostStatus = 65536;
constexpr std::size_t kMostServices = 256;

/// Whether `value` lies within -most...most; false for what is not a number.
inline bool isWithin(double value, double most) { return std::abs(value) <= most; }

}  // namespace frontier_pilot::bounds
