#pragma once

#include <limits>
#include <optional>
#include <set>
#include <string>

#include "frontier_pilot/navigation/navigator.h"
#include "frontier_pilot/sim/simulator.h"
#include "frontier_pilot/system/behavior_ladder.h"
#include "support/ascii_world.h"

namespace frontier_pilot::test {

/// The navigator in lockstep with the simulator, at 20 Hz, on a known map.
class DrivenRobot {
 public:
  DrivenRobot(const AsciiWorld& world, const Pose2& start, const navigation::NavigatorParams& params = {})
      : DrivenRobot(world.map, start, params) {}
  DrivenRobot(const OccupancyGrid& map, const Pose2& start, const navigation::NavigatorParams& params = {})
      : simulator_(sim::World{map, start}, simulation(start, params.robot)),
        navigator_(params, system::behaviorLadder(params, 20.0)),
        placer_(params.robot.scanner) {
    navigator_.setMap(map, map.geometry().rect());
  }

  /// The parameters of a robot with the fast set of limits.
  static navigation::NavigatorParams fast() {
    navigation::NavigatorParams params;
    params.robot.limits.max_linear = 0.5;
    params.robot.limits.max_angular = 1.5;
    return params;
  }

  void send(const Vec2& goal, std::uint64_t id = 1) { sendPose({goal, 0.0}, false, id); }
  void sendPose(const Pose2& goal, bool use_yaw, std::uint64_t id = 1) {
    event_.new_goal = navigation::NavGoal{id, goal, use_yaw};
  }
  void cancel() { event_.cancel = true; }
  void replaceMap() { event_.map_replaced = true; }

  /// One tick of 50 ms.
  const navigation::NavigatorOutput& tick() {
    for (int i = 0; i < 5; ++i) step();
    navigation::NavigatorInputs inputs = event_;
    event_ = {};
    if (has_pose) inputs.pose = StampedPose2{simulator_.now() + pose_ahead, simulator_.pose(0)};
    if (has_scan && scan_) inputs.scan = &*scan_;
    inputs.map_alive = has_map;
    inputs.localized = is_localized;
    inputs.order = order;
    inputs.twist = simulator_.velocity(0);
    output_ = navigator_.update(inputs, simulator_.now());
    if (output_.command) simulator_.setCommand(0, held ? Twist2{} : *output_.command);
    if (!output_.recovery.empty()) recoveries.insert(output_.recovery);
    for (const navigation::NavFinished& finished : output_.finished) finished_ = finished;
    return output_;
  }

  /// Ticks until a goal ends, which is returned, or until `seconds` have passed.
  std::optional<navigation::NavFinished> runUntilFinished(double seconds) {
    finished_.reset();
    const Time end = simulator_.now() + fromSeconds(seconds);
    while (!finished_ && simulator_.now() < end) tick();
    return finished_;
  }
  void run(double seconds) {
    const Time end = simulator_.now() + fromSeconds(seconds);
    while (simulator_.now() < end) tick();
  }

  sim::Simulator& simulator() { return simulator_; }
  navigation::Navigator& navigator() { return navigator_; }
  const navigation::NavigatorOutput& output() const { return output_; }
  const Pose2& pose() const { return simulator_.pose(0); }
  double speed() const { return simulator_.velocity(0).linear; }
  int contacts() const { return simulator_.contactCount(0); }
  double standingTime() const { return standing_; }

  bool has_pose = true;
  Duration pose_ahead{};  ///< how far the stamps of the poses are ahead of the clock
  bool has_scan = true;
  bool has_map = true;
  bool is_localized = true;
  navigation::NavOrder order;        ///< of the traffic, for each tick
  bool held = false;                 ///< the wheels do not turn, whatever the navigator commands
  bool is_blind = false;             ///< the scanner reports no return from any direction
  std::set<std::string> recoveries;  ///< all that the navigator has reported

 private:
  static sim::SimulatorParameters simulation(const Pose2& start, const RobotModel& robot) {
    sim::SimulatorParameters params;
    params.x = start.x;
    params.y = start.y;
    params.yaw = start.yaw;
    params.robot = robot;
    return params;
  }

  void step() {
    simulator_.step();
    placer_.addOdometry(simulator_.now(), simulator_.odometry(0));
    if (const LaserScan2* scan = simulator_.newScan(0)) {
      scan_ = *scan;
      if (is_blind) scan_->ranges.assign(scan_->ranges.size(), std::numeric_limits<float>::infinity());
      placer_.place(ScanReference::kEnd, *scan_);
    }
    if (std::abs(speed()) < 0.01) standing_ += 0.01;
  }

  sim::Simulator simulator_;
  navigation::Navigator navigator_;
  ScanPlacer placer_;
  navigation::NavigatorInputs event_;
  std::optional<LaserScan2> scan_;
  navigation::NavigatorOutput output_;
  std::optional<navigation::NavFinished> finished_;
  double standing_ = 0.0;
};

}  // namespace frontier_pilot::test
