#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/arbiter/arbiter.h"
#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/exploration/explorer.h"
#include "frontier_pilot/mapping/mapper.h"
#include "frontier_pilot/navigation/navigator.h"
#include "frontier_pilot/sim/simulator.h"

namespace frontier_pilot::system {

/// The parameters of every part, the same as those of the nodes.
struct ClosedLoopParameters {
  sim::SimulatorParameters simulator;
  mapping::MapperParameters mapper = trustingOdometry();  ///< as system.launch sets it without odometry noise
  navigation::NavigatorParams navigator;
  exploration::ExplorerParameters explorer;
  arbiter::ArbiterParameters arbiter;
  double latency = 0.0;     ///< from a measurement to its use [s]
  double head_start = 0.0;  ///< how much later than everything else the explorer starts [s]

  static mapping::MapperParameters trustingOdometry() {
    mapping::MapperParameters parameters;
    parameters.trust_odometry = true;
    return parameters;
  }
  /// Sets the robot of every part.
  void setRobot(const RobotModel& robot);
  /// Sets the limits of the robot of every part.
  void setLimits(const RobotLimits& limits);
};

/// How long each part was at work [s], by the `wall_clock` of the ClosedLoop.
struct ModuleTimes {
  double simulator = 0.0;
  double mapper = 0.0;
  double navigator = 0.0;
  double explorer = 0.0;
  double arbiter = 0.0;
  std::vector<double> decisions;  ///< of each tick that judged the frontiers, which `explorer` includes too

  double sum() const { return simulator + mapper + navigator + explorer + arbiter; }
};

/// Simulator, mapper, navigator, explorer and arbiter in lockstep in one process; system.launch connects the same parts
/// by topics. Simulated time only; deterministic for a seed.
class ClosedLoop {
 public:
  /// Throws what the constructors of sim::Simulator and arbiter::Arbiter throw. `wall_clock` [s], if given, only serves
  /// to fill `times()`.
  ClosedLoop(sim::World world, const ClosedLoopParameters& parameters, double (*wall_clock)() = nullptr);

  /// One step of the simulator, and everything that is due then.
  void step();
  /// Enables or disables the arbiter's source `nav`. While it is disabled the robot is commanded to stand still.
  void setNavEnabled(bool on);

  Time now() const { return simulator_.now(); }
  sim::Simulator& simulator() { return simulator_; }
  const mapping::Mapper& mapper() const { return mapper_; }
  const navigation::Navigator& navigator() const { return navigator_; }
  /// What the navigator said in its last cycle.
  const navigation::NavigatorOutput& navigation() const { return navigation_; }
  const exploration::Explorer& explorer() const { return explorer_; }
  const exploration::ExplorerProgress& status() const { return status_; }
  bool done() const { return status_.state == exploration::ExplorerState::kDone; }
  /// Every transition and note of the explorer and every result of a goal since the last call, one line each.
  std::vector<std::string> takeLog();
  const ModuleTimes& times() const { return times_; }
  /// FNV-1a over the robot's poses, commands and decisions so far: equal runs have equal hashes.
  std::uint64_t hash() const { return hash_; }

 private:
  /// The readings of the robot's sensors at one moment.
  struct Sensed {
    MotionSample odometry;
    std::optional<LaserScan2> scan;
  };

  void sense();
  void control();
  void explore();
  void navigate();
  void noteGoals(const navigation::NavigatorOutput& output);
  Instant instant() const;
  StampedPose2 lastPose() const;
  void log(const std::string& line);
  void mix(double value);

  /// Adds the time that a scope took.
  class Stopwatch;

  sim::Simulator simulator_;
  mapping::Mapper mapper_;
  navigation::Navigator navigator_;
  exploration::Explorer explorer_;
  arbiter::Arbiter arbiter_;
  std::size_t nav_source_;
  double (*wall_clock_)();

  Duration head_start_;
  Duration latency_;
  std::deque<Sensed> on_the_way_;
  Sensed sensed_;  ///< the latest that has arrived
  ScanPlacer placer_;
  LaserScan2 scan_;
  exploration::GoalCommand pending_;
  navigation::NavigatorOutput navigation_;
  std::uint32_t goal_id_ = 0;
  std::vector<exploration::GoalEvent> goal_events_;
  exploration::ExplorerProgress status_;
  std::vector<std::string> log_;
  ModuleTimes times_;
  std::uint64_t hash_ = 14695981039346656037ULL;
  std::uint64_t steps_ = 0;
};

}  // namespace frontier_pilot::system
