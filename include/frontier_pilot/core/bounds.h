#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

/// Every limit on a number from outside (a message, a service call, a file) that determines how much memory or work it
/// costs. Input beyond a limit is refused with a reason and counted. docs/limits.md lists them for operators. [FLT-1]
namespace frontier_pilot::bounds {

/// Largest coordinate of a pose [m]. No wheeled robot gets that far, and at the finest resolution the indices of cells
/// that far away, and sums of a few such indices, still fit into an int.
constexpr double kMostCoordinate = 1e6;
/// Largest speed that odometry may report [m/s, rad/s]. Poses are extrapolated with it and must stay plausible.
constexpr double kMostSpeed = 100.0;

/// Odometry messages that are kept for looking up the pose at a stamp: five seconds of them at 1 kHz.
constexpr std::size_t kMostOdometry = 5000;

/// Largest distance from the base to a sensor mounted on it [m]: longer than any vehicle that could carry one.
constexpr double kMostMount = 10.0;
/// Beams of a scan: a full turn in steps of 0.01 degrees. Real scanners have up to a few thousand.
constexpr std::size_t kMostRanges = 36000;
/// Beams of a scan that the mapper uses; of a denser scan it takes every n-th. They are 0.05 degrees apart on a full
/// turn, so that up to 57 m away neighbouring beams hit the same 5 cm cell or adjacent ones.
constexpr std::size_t kMostMappedBeams = 7200;
/// Smallest angle between neighbouring beams [rad]: about 0.001 degrees. Code divides by it.
constexpr double kLeastAngleIncrement = 1.7e-5;
/// Largest absolute value of a scan's first and last angle [rad], two turns: drivers start at -pi, 0 or 2 pi.
constexpr double kMostAngle = 12.6;
/// Largest `range_max` of a scan [m]: no scanner sees farther.
constexpr double kMostRange = 1000.0;
/// How much of a range is used [m]: a beam that ends farther away counts as free up to here.
constexpr double kUsedRange = 100.0;

/// Side of a map's cell [m]. Distances divided by it determine how many cells a window around the robot has. 1 cm is
/// finer than a scanner can resolve, 10 m is wider than any robot that could navigate with such a map.
constexpr double kLeastResolution = 0.01;
constexpr double kMostResolution = 10.0;
/// Cells along a side of a map: one kilometre at 5 cm.
constexpr int kMostSide = 20000;
/// Cells of a map that a node accepts: those of 600 m x 600 m in cells of 10 cm, and a tenth more. The navigator keeps
/// 14 bytes for each and needs 18 at its peak: 560 MB and 720 MB.
constexpr std::size_t kMostMapCells = 40'000'000;

/// Sides of occupied cells next to free ones in a map that scans are to be matched with: 170 bytes each while it is
/// loaded, so 340 MB. The walls of 160,000 m^2 of offices have as many; a picture of noise has several times more.
constexpr std::size_t kMostSurfacePoints = 2'000'000;

/// Frontier cells of a map that the explorer sorts into clusters. An office building of 250 m x 250 m that is known in
/// patches has 1.2 million; a map of pure noise has several times as many.
constexpr std::size_t kMostFrontierCells = 2'000'000;
/// Clusters of frontier cells. That building has 60,000, most of them too small to be worth a goal.
constexpr std::size_t kMostFrontiers = 100'000;
/// Reachable frontiers for which the explorer looks for a goal at each decision; each costs a quarter of a millisecond.
constexpr std::size_t kMostJudgedFrontiers = 4000;
/// Corners of all polygons together that bound an exploration. Each is looked at once for each row of a map, and all of
/// them stand in the explorer's status.
constexpr std::size_t kMostBoundsCorners = 2000;

/// Poses of a path.
constexpr std::size_t kMostPathPoses = 100'000;
/// How far from the goal a plan may end [m]: all cells within that radius are examined.
constexpr double kMostGoalTolerance = 5.0;
/// Cells that a plan may end in: those nearest to the goal.
constexpr std::size_t kMostGoalCells = 10'000;

/// States (position and heading) that the search for a path of a robot that is not a disc expands, and again that for
/// one through tight places: about a second of work for a robot of the size of a TurtleBot; its outline is looked at at
/// each, so that one of 1.6 m x 0.8 m takes several times that.
constexpr std::size_t kMostOrientedStates = 200'000;

/// Obstacles in the simulated world, and their radius [m]: each is listed in every 2 m bin that it touches.
constexpr std::size_t kMostObstacles = 1000;
constexpr double kMostObstacleRadius = 10.0;
/// Characters of a name that is stored: of an obstacle, a source or a frame.
constexpr std::size_t kMostName = 256;

/// Frames in TF: each is kept for as long as the node lives.
constexpr std::size_t kMostFrames = 1000;
/// Characters of a goal id, which is stored and published. Ids made by actionlib consist of a node's name, a counter
/// and a time.
constexpr std::size_t kMostGoalId = 1024;
/// Goals of an action that are remembered after they have ended, or after a cancel came for an unknown id.
constexpr std::size_t kMostTrackedGoals = 64;

/// Map updates, and their cells, that are kept to be applied to a whole map that arrives late: 16 MB, or five minutes
/// of the mapper's updates.
constexpr std::size_t kMostRecentUpdates = 2000;
constexpr std::size_t kMostRecentCells = std::size_t{1} << 24;

/// The image of a simulated world: its bytes, its pixels (8000 x 8000), and the side of a pixel, the side of the world
/// and the coordinates of its origin [m]. They determine the size of grids and of the ray caster's index.
constexpr std::size_t kMostImageBytes = 300'000'000;
constexpr std::uint64_t kMostPixels = 64'000'000;
constexpr double kLeastPixelSize = 0.001;
constexpr double kMostPixelSize = 1.0;
constexpr double kMostWorldSide = 5000.0;
constexpr double kMostWorldOrigin = 1e5;

/// A YAML file: its bytes, its values, and how deep they are nested. With aliases, a few lines can expand to more
/// values than fit into memory.
constexpr std::size_t kMostYamlBytes = 1'000'000;
constexpr int kMostYamlValues = 100'000;
constexpr int kMostYamlDepth = 32;

/// Characters of the reason for a refusal, and how many reasons are counted separately: a reason may quote the input.
constexpr std::size_t kMostReason = 256;
constexpr std::size_t kMostReasons = 32;
/// Bytes of a log line, and of a text in the diagnostics.
constexpr std::size_t kMostLine = 500;
constexpr std::size_t kMostDiagnostic = 2000;

/// Bytes of a status message that the operator's window shows, and services that it watches because a status named
/// their source.
constexpr unsigned kMostStatus = 65536;
constexpr std::size_t kMostServices = 256;

/// Whether `value` lies in [-most, most]; false for NaN.
inline bool isWithin(double value, double most) { return std::abs(value) <= most; }

}  // namespace frontier_pilot::bounds
