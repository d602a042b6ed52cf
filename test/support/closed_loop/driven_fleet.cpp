#include "support/closed_loop/driven_fleet.h"

#include <algorithm>
#include <cmath>

#include "frontier_pilot/system/behavior_ladder.h"
#include "sim/random.h"

namespace frontier_pilot::test {
namespace {

constexpr double kRate = 10.0;  // [Hz]
constexpr int kStepsPerCycle = 10;
constexpr int kStepsPerMessage = 50;

sim::SimulatorParameters simulation(const std::vector<Pose2>& starts, const RobotModel& robot) {
  sim::SimulatorParameters params;
  params.robot = robot;
  for (const Pose2& start : starts) {
    params.robots.push_back({"robot" + std::to_string(params.robots.size() + 1), start.x, start.y, start.yaw});
  }
  return params;
}

}  // namespace

DrivenFleet::Robot::Robot(const std::string& name, const navigation::NavigatorParams& params)
    : navigator(params, system::behaviorLadder(params, kRate)),
      rule(name, params.robot.drivenOutline().circumscribedRadius()),
      placer(params.robot.scanner) {}

DrivenFleet::DrivenFleet(const OccupancyGrid& map, const std::vector<Pose2>& starts,
                         const navigation::NavigatorParams& params, bool rule)
    : map_(map), simulator_(sim::World{map, starts.front()}, simulation(starts, params.robot)), rule_(rule) {
  for (std::size_t i = 0; i < starts.size(); ++i) {
    robots_.push_back(std::make_unique<Robot>(simulator_.name(i), params));
    robots_.back()->navigator.setMap(map, map.geometry().rect());
  }
}

void DrivenFleet::send(std::size_t robot, const Vec2& goal) {
  robots_[robot]->goal = goal;
  robots_[robot]->new_goal = true;
}

void DrivenFleet::step() {
  simulator_.step();
  ++steps_;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = *robots_[i];
    robot.placer.addOdometry(simulator_.now(), simulator_.odometry(i));
    if (const LaserScan2* scan = simulator_.newScan(i)) {
      robot.scan = *scan;
      robot.placer.place(ScanReference::kEnd, *robot.scan);
    }
    const bool excused = !robot.goal || !robot.powered || !robot.output.traffic.empty();
    robot.standing.observe(simulator_.pose(i), excused, now());
    if (robot.powered && steps_ % kStepsPerCycle == 0) control(i);
  }
  if (rule_ && steps_ % kStepsPerMessage == 0) tell();
}

void DrivenFleet::control(std::size_t index) {
  Robot& robot = *robots_[index];
  navigation::NavigatorInputs inputs;
  inputs.pose = StampedPose2{now(), simulator_.pose(index)};
  if (robot.scan) inputs.scan = &*robot.scan;
  inputs.twist = simulator_.velocity(index);
  if (robot.goal && robot.new_goal) inputs.new_goal = navigation::NavGoal{1, {*robot.goal, 0.0}, false};
  robot.new_goal = false;
  if (rule_) applyRule(robot, index, inputs);
  robot.output = robot.navigator.update(inputs, now());
  if (robot.output.command) simulator_.setCommand(index, *robot.output.command);
  for (const navigation::NavFinished& finished : robot.output.finished) {
    robot.new_goal = finished.result != navigation::NavResult::kSucceeded;
    if (robot.new_goal) ++given_up_;
    if (!robot.new_goal) robot.goal.reset();
  }
}

void DrivenFleet::applyRule(Robot& robot, std::size_t index, navigation::NavigatorInputs& inputs) {
  fleet::TrafficInputs traffic;
  traffic.T_map_base = simulator_.pose(index);
  traffic.goal = robot.goal;
  traffic.path = robot.navigator.wayAhead();
  traffic.aside_failed = robot.output.aside_failed;
  traffic.map = &map_;
  traffic.T_map_common = Pose2();
  inputs.order = robot.rule.update(traffic, now()).forNavigator();
}

void DrivenFleet::tell() {
  for (const auto& robot : robots_) {
    const auto message = robot->powered ? robot->rule.message() : std::nullopt;
    if (message) hear(*message);
  }
}

void DrivenFleet::hear(const fleet::MotionMessage& message) {
  for (const auto& robot : robots_) robot->rule.hear(message, now());
}

bool DrivenFleet::run(double seconds) {
  const Time end = now() + fromSeconds(seconds);
  const auto all = [this] {
    return std::all_of(robots_.begin(), robots_.end(),
                       [](const auto& robot) { return !robot->goal || !robot->powered; });
  };
  while (!all() && now() < end) step();
  return all();
}

int DrivenFleet::contacts() const {
  int sum = 0;
  for (std::size_t i = 0; i < robots_.size(); ++i) sum += simulator_.contactCount(i);
  return sum;
}

double DrivenFleet::longestStanding() const {
  double longest = 0.0;
  for (const auto& robot : robots_) longest = std::max(longest, robot->standing.longest());
  return longest;
}

Meeting drawMeeting(int seed, double width) {
  constexpr double kCell = 0.05;      // [m]
  constexpr double kRoom = 4.0;       // [m]: side of the rooms
  constexpr double kCorridor = 10.0;  // [m]
  Meeting meeting;
  const auto cells = [&](double length) { return static_cast<int>(std::lround(length / kCell)); };
  meeting.map = OccupancyGrid(
      GridGeometry{kCell, Vec2::Zero(), cells(2.0 * kRoom + kCorridor + 0.2), cells(kRoom + 0.2)}, kOccupied);
  const double middle = 0.1 + 0.5 * kRoom;
  for (std::size_t i = 0; i < meeting.map.size(); ++i) {
    const Vec2 at = meeting.map.geometry().centre(meeting.map.geometry().cell(i));
    const bool inside = at.y() > 0.1 && at.y() < kRoom + 0.1 && at.x() > 0.1 && at.x() < 2.0 * kRoom + kCorridor + 0.1;
    const bool room = at.x() < kRoom + 0.1 || at.x() > kRoom + kCorridor + 0.1;
    if (inside && (room || std::abs(at.y() - middle) < 0.5 * width)) meeting.map[i] = kFree;
  }
  sim::Random random(static_cast<std::uint64_t>(seed));
  for (const double side : {0.0, 1.0}) {
    const double depth = 0.5 + random.uniform() * (kRoom + 4.0);  // from the outer wall
    const double slack = depth < kRoom - 0.5 ? 0.5 * kRoom - 0.5 : 0.5 * width - 0.3;
    const double y = middle + (2.0 * random.uniform() - 1.0) * slack;
    const double x = 0.1 + depth;
    const double across = 2.0 * kRoom + kCorridor + 0.2;
    meeting.starts.emplace_back(side > 0.0 ? across - x : x, y, side > 0.0 ? kPi : 0.0);
    const double goal = 0.1 + 0.6 + random.uniform() * (kRoom - 1.2);
    meeting.goals.emplace_back(side > 0.0 ? goal : across - goal, middle + (2.0 * random.uniform() - 1.0) * 1.2);
  }
  return meeting;
}

}  // namespace frontier_pilot::test
