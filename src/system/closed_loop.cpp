#include "frontier_pilot/system/closed_loop.h"

#include <cstring>
#include <sstream>
#include <stdexcept>

#include "frontier_pilot/system/behavior_ladder.h"

namespace frontier_pilot::system {
namespace {

constexpr std::uint64_t kStepsPerControl = 10;
constexpr double kControlFrequency = 10.0;  // [Hz]: once in kStepsPerControl steps of 10 ms
constexpr std::uint64_t kStepsPerTick = 5;  // the arbiter's 20 Hz

exploration::GoalEvent::Kind eventKind(navigation::NavResult result) {
  if (result == navigation::NavResult::kSucceeded) return exploration::GoalEvent::Kind::kReached;
  return result == navigation::NavResult::kAborted ? exploration::GoalEvent::Kind::kAborted
                                                   : exploration::GoalEvent::Kind::kPreempted;
}

}  // namespace

class ClosedLoop::Stopwatch {
 public:
  Stopwatch(double (*clock)(), double& total)
      : clock_(clock), total_(total), start_(clock != nullptr ? clock() : 0.0) {}
  ~Stopwatch() {
    if (clock_ != nullptr) total_ += clock_() - start_;
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double (*clock_)();
  double& total_;
  double start_;
};

void ClosedLoopParameters::setRobot(const RobotModel& robot) {
  simulator.robot = mapper.robot = navigator.robot = explorer.robot = arbiter.robot = robot;
}

void ClosedLoopParameters::setLimits(const RobotLimits& limits) {
  for (RobotModel* robot : {&simulator.robot, &mapper.robot, &navigator.robot, &explorer.robot, &arbiter.robot}) {
    robot->limits = limits;
  }
}

ClosedLoop::ClosedLoop(sim::World world, const ClosedLoopParameters& parameters, double (*wall_clock)())
    : simulator_(std::move(world), parameters.simulator),
      mapper_(parameters.mapper),
      navigator_(parameters.navigator,
                 behaviorLadder(parameters.navigator.recovery, parameters.navigator.robot, kControlFrequency)),
      explorer_(parameters.explorer),
      arbiter_(parameters.arbiter),
      nav_source_(arbiter_.find("nav").value()),
      wall_clock_(wall_clock),
      head_start_(fromSeconds(parameters.head_start)),
      latency_(fromSeconds(parameters.latency)),
      placer_(parameters.mapper.robot.scanner) {}

void ClosedLoop::step() {
  {
    const Stopwatch watch(wall_clock_, times_.simulator);
    simulator_.step();
  }
  ++steps_;
  sense();
  if (steps_ % kStepsPerControl == 0) control();
  if (steps_ % kStepsPerTick == 0) {
    const Stopwatch watch(wall_clock_, times_.arbiter);
    if (const auto twist = arbiter_.tick(instant())) simulator_.setCommand(0, *twist);
  }
}

void ClosedLoop::setNavEnabled(bool on) { arbiter_.setEnabled(nav_source_, on, instant()); }

void ClosedLoop::sense() {
  const LaserScan2* scan = simulator_.newScan(0);
  on_the_way_.push_back({{now(), simulator_.odometry(0), simulator_.velocity(0)},
                         scan != nullptr ? std::optional<LaserScan2>(*scan) : std::nullopt});
  while (!on_the_way_.empty() && now() - on_the_way_.front().odometry.stamp >= latency_) {
    sensed_ = std::move(on_the_way_.front());
    on_the_way_.pop_front();
    placer_.addOdometry(sensed_.odometry.stamp, sensed_.odometry.T_odom_base);
    if (!sensed_.scan) continue;
    const Stopwatch watch(wall_clock_, times_.mapper);
    LaserScan2 mapped = *sensed_.scan;
    placer_.place(ScanReference::kMiddle, mapped);
    mapper_.insert(mapped, placer_.track().nearest(mapped.stamp), now());
    scan_ = std::move(*sensed_.scan);
    placer_.place(ScanReference::kEnd, scan_);
    mapper_.reviseNow();
  }
}

void ClosedLoop::control() {
  const occupancy::MapChanges changes = mapper_.takeChanges();
  if (!changes.empty()) {
    {
      const Stopwatch watch(wall_clock_, times_.navigator);
      navigator_.setMap(mapper_.grid(), changes.cells);
    }
    const Stopwatch watch(wall_clock_, times_.explorer);
    explorer_.setMap(mapper_.grid(), changes.cells);
  }
  explore();
  navigate();
  const Pose2& pose = simulator_.pose(0);
  for (const double value : {pose.x, pose.y, pose.yaw}) mix(value);
}

StampedPose2 ClosedLoop::lastPose() const {
  return {sensed_.odometry.stamp, mapper_.T_map_odom() * sensed_.odometry.T_odom_base};
}

Instant ClosedLoop::instant() const { return {now(), SteadyTime(now().time_since_epoch())}; }

void ClosedLoop::explore() {
  const Stopwatch watch(wall_clock_, times_.explorer);
  exploration::ExplorerInputs inputs;
  inputs.enabled = now().time_since_epoch() >= head_start_;
  inputs.map_available = !mapper_.grid().empty();
  inputs.T_map_base = lastPose();
  inputs.odometry_stamp = sensed_.odometry.stamp;
  inputs.goal_events.swap(goal_events_);
  exploration::ExplorerOutput output;
  double took = 0.0;
  {
    const Stopwatch update(wall_clock_, took);
    output = explorer_.update(inputs, now());
  }
  if (output.frontiers_judged) times_.decisions.push_back(took);
  if (output.command.kind != exploration::GoalCommand::Kind::kNone) pending_ = output.command;
  status_ = output.status;
  for (const exploration::ExplorerProgress& transition : output.transitions) {
    log(std::string(toString(transition.state)) + ": " + toString(transition.reason) + " " + transition.reason_text);
    mix(static_cast<double>(transition.state));
  }
  for (const exploration::ExplorerNote& note : output.notes) log(note.text);
}

void ClosedLoop::navigate() {
  {
    const Stopwatch watch(wall_clock_, times_.navigator);
    navigation::NavigatorInputs inputs;
    inputs.pose = lastPose();
    inputs.scan = scan_.ranges.empty() ? nullptr : &scan_;
    inputs.twist = sensed_.odometry.twist;
    if (pending_.kind == exploration::GoalCommand::Kind::kSend)
      inputs.new_goal = navigation::NavGoal{pending_.goal_id, pending_.goal, false};
    inputs.cancel = pending_.kind == exploration::GoalCommand::Kind::kCancel;
    pending_ = {};
    navigation_ = navigator_.update(inputs, now());
    noteGoals(navigation_);
  }
  if (!navigation_.command) return;
  const Stopwatch watch(wall_clock_, times_.arbiter);
  if (const auto twist = arbiter_.onCommand(nav_source_, *navigation_.command, instant())) {
    simulator_.setCommand(0, *twist);
    mix(twist->linear);
    mix(twist->angular);
  }
}

void ClosedLoop::noteGoals(const navigation::NavigatorOutput& output) {
  for (const navigation::NavFinished& finished : output.finished) {
    goal_events_.push_back(
        {static_cast<std::uint32_t>(finished.id), eventKind(finished.result), toString(finished.reason)});
    log("goal " + std::to_string(finished.id) + " " + toString(finished.result) + ": " + toString(finished.reason));
  }
}

void ClosedLoop::log(const std::string& line) {
  std::ostringstream out;
  out.precision(2);
  out << std::fixed << toSeconds(now()) << " " << line;
  log_.push_back(out.str());
}

std::vector<std::string> ClosedLoop::takeLog() {
  std::vector<std::string> out;
  out.swap(log_);
  return out;
}

void ClosedLoop::mix(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  hash_ = (hash_ ^ bits) * 1099511628211ULL;
}

}  // namespace frontier_pilot::system
