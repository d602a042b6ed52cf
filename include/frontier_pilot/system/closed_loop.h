#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "frontier_pilot/arbiter/arbiter.h"
#include "frontier_pilot/core/grid.h"
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
  bool agree = true;        ///< whether several robots agree who goes where [MUL-2]
  bool give_way = true;     ///< whether several robots agree who goes first [MUL-3]
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

class RobotStack;

/// The simulator, and for each of its robots a mapper, a navigator, an explorer and an arbiter, in lockstep in one
/// process; system.launch connects the same parts by topics. Several robots explore on one map, merged in each robot's
/// own map frame. Robots are numbered as in the simulator. Simulated time only; deterministic for a seed. [MUL-1]
class ClosedLoop {
 public:
  /// Throws what the constructors of sim::Simulator and arbiter::Arbiter throw. `wall_clock` [s], if given, only serves
  /// to fill `times()`.
  ClosedLoop(sim::World world, const ClosedLoopParameters& parameters, double (*wall_clock)() = nullptr);
  ~ClosedLoop();
  ClosedLoop(const ClosedLoop&) = delete;
  ClosedLoop& operator=(const ClosedLoop&) = delete;

  /// One step of the simulator, and everything that is due then.
  void step();
  /// A robot that is off neither drives, maps nor says anything; on again, it goes on with what it knew. [MUL-2]
  void setPowered(std::size_t robot, bool on);
  /// Enables or disables the arbiter's source `nav`. While it is disabled the robot is commanded to stand still.
  void setNavEnabled(bool on, std::size_t robot = 0);

  Time now() const { return simulator_.now(); }
  sim::Simulator& simulator() { return simulator_; }
  std::size_t robotCount() const { return stacks_.size(); }
  const mapping::Mapper& mapper(std::size_t robot = 0) const;
  /// The map that navigator and explorer work on: the robot's own, or with several robots all of theirs in its frame.
  const OccupancyGrid& view(std::size_t robot = 0) const;
  const navigation::Navigator& navigator(std::size_t robot = 0) const;
  /// What the navigator said in its last cycle.
  const navigation::NavigatorOutput& navigation(std::size_t robot = 0) const;
  const exploration::Explorer& explorer(std::size_t robot = 0) const;
  const exploration::ExplorerProgress& status(std::size_t robot = 0) const;
  /// Whether every robot that is on is done.
  bool done() const;
  /// Every transition and note of the explorer and every result of a goal since the last call, one line each.
  std::vector<std::string> takeLog(std::size_t robot = 0);
  /// Of all robots together.
  ModuleTimes times() const;
  /// FNV-1a over the robots' poses, commands and decisions so far: equal runs have equal hashes.
  std::uint64_t hash() const;

 private:
  void shareMaps();
  void shareMap(std::size_t source, const std::vector<CellRect>& changed);
  void shareClaims();
  void shareMotions();

  sim::Simulator simulator_;
  bool agree_;
  bool give_way_;
  std::vector<std::unique_ptr<RobotStack>> stacks_;
  double (*wall_clock_)();
  double simulator_time_ = 0.0;  ///< that the simulator was at work [s]
  std::uint64_t steps_ = 0;
};

}  // namespace frontier_pilot::system
