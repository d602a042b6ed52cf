#include "system/robot_stack.h"

#include <cstring>
#include <sstream>
#include <utility>

#include "frontier_pilot/system/behavior_ladder.h"
#include "system/stopwatch.h"

namespace frontier_pilot::system {
namespace {

constexpr double kControlFrequency = 10.0;  // [Hz], as ClosedLoop calls control()

exploration::GoalEvent::Kind eventKind(const navigation::NavFinished& finished) {
  using Kind = exploration::GoalEvent::Kind;
  if (finished.result == navigation::NavResult::kSucceeded) return Kind::kReached;
  if (finished.result != navigation::NavResult::kAborted) return Kind::kPreempted;
  return isNoFaultOfTheGoal(finished.reason) ? Kind::kUnable : Kind::kAborted;
}

}  // namespace

RobotStack::RobotStack(sim::Simulator& simulator, std::size_t robot, const ClosedLoopParameters& parameters,
                       double (*wall_clock)())
    : simulator_(simulator),
      robot_(robot),
      T_common_map_(simulator.startPose(0).inverse() * simulator.startPose(robot)),
      book_(simulator.name(robot)),
      gives_way_(parameters.give_way && simulator.robotCount() > 1),
      rule_(simulator.name(robot), parameters.navigator.robot.drivenOutline().circumscribedRadius()),
      mapper_(parameters.mapper),
      navigator_(parameters.navigator, behaviorLadder(parameters.navigator, kControlFrequency)),
      explorer_(parameters.explorer),
      arbiter_(parameters.arbiter),
      nav_source_(arbiter_.find("nav").value()),
      wall_clock_(wall_clock),
      head_start_(fromSeconds(parameters.head_start)),
      latency_(fromSeconds(parameters.latency)),
      placer_(parameters.mapper.robot.scanner) {}

void RobotStack::sense() {
  const LaserScan2* scan = simulator_.newScan(robot_);
  on_the_way_.push_back({{now(), simulator_.odometry(robot_), simulator_.velocity(robot_)},
                         scan != nullptr ? std::optional<LaserScan2>(*scan) : std::nullopt});
  while (!on_the_way_.empty() && now() - on_the_way_.front().odometry.stamp >= latency_) {
    sensed_ = std::move(on_the_way_.front());
    on_the_way_.pop_front();
    placer_.addOdometry(sensed_.odometry.stamp, sensed_.odometry.T_odom_base);
    if (sensed_.scan) map(*sensed_.scan);
  }
}

void RobotStack::map(const LaserScan2& scan) {
  const Stopwatch watch(wall_clock_, times_.mapper);
  LaserScan2 mapped = scan;
  placer_.place(ScanReference::kMiddle, mapped);
  mapper_.insert(mapped, placer_.track().nearest(mapped.stamp), now());
  scan_ = scan;
  placer_.place(ScanReference::kEnd, scan_);
  mapper_.reviseNow();
}

void RobotStack::setMap(const OccupancyGrid& map, const CellRect& changed) {
  {
    const Stopwatch watch(wall_clock_, times_.navigator);
    navigator_.setMap(map, changed);
  }
  const Stopwatch watch(wall_clock_, times_.explorer);
  explorer_.setMap(map, changed);
}

void RobotStack::followMapper() {
  const CellRect changed = mapper_.takeChanges().cells;
  if (changed.empty()) return;
  if (simulator_.robotCount() == 1) return setMap(mapper_.grid(), changed);
  unpublished_.include(changed);
  std::vector<CellRect> parts;
  {
    const Stopwatch watch(wall_clock_, times_.mapper);
    parts = followed_.take(mapper_.grid(), changed);
  }
  if (!parts.empty()) mergeMap(robot_, followed_.map(), parts, {});
}

std::vector<CellRect> RobotStack::publishMap() {
  const Stopwatch watch(wall_clock_, times_.mapper);
  const CellRect changed = std::exchange(unpublished_, {});
  return changed.empty() ? std::vector<CellRect>() : published_.take(mapper_.grid(), changed);
}

void RobotStack::mergeMap(std::size_t source, const OccupancyGrid& map, const std::vector<CellRect>& changed,
                          const Pose2& T_map_source) {
  {
    const Stopwatch watch(wall_clock_, times_.mapper);
    const std::size_t index = source == robot_ ? 0 : source + 1;
    view_.setSourceParts(index, map, changed, T_map_source);
  }
  const CellRect differing = view_.takeChanged();
  if (!differing.empty()) setMap(view_.map(), differing);
}

fleet::ClaimsMessage RobotStack::claims() const {
  return fleet::makeClaimsMessage(simulator_.name(robot_), lastPose().pose, explorer_.claims(), T_common_map_);
}

void RobotStack::control() {
  explore();
  navigate();
  const Pose2& pose = simulator_.pose(robot_);
  for (const double value : {pose.x, pose.y, pose.yaw}) mix(value);
}

void RobotStack::arbitrate() {
  const Stopwatch watch(wall_clock_, times_.arbiter);
  if (const auto twist = arbiter_.tick(instant())) simulator_.setCommand(robot_, *twist);
}

StampedPose2 RobotStack::lastPose() const {
  return {sensed_.odometry.stamp, mapper_.T_map_odom() * sensed_.odometry.T_odom_base};
}

Instant RobotStack::instant() const { return {now(), SteadyTime(now().time_since_epoch())}; }

void RobotStack::explore() {
  const Stopwatch watch(wall_clock_, times_.explorer);
  exploration::ExplorerInputs inputs;
  inputs.enabled = now().time_since_epoch() >= head_start_;
  inputs.map_available = !view().empty();
  inputs.T_map_base = lastPose();
  inputs.localized = mapper_.isLocalized();
  inputs.odometry_stamp = sensed_.odometry.stamp;
  inputs.goal_events.swap(goal_events_);
  inputs.others = book_.others(T_common_map_.inverse(), now());
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

void RobotStack::navigate() {
  {
    const Stopwatch watch(wall_clock_, times_.navigator);
    navigation::NavigatorInputs inputs;
    inputs.pose = lastPose();
    inputs.scan = scan_.ranges.empty() ? nullptr : &scan_;
    inputs.localized = mapper_.isLocalized();
    inputs.twist = sensed_.odometry.twist;
    if (pending_.kind == exploration::GoalCommand::Kind::kSend)
      inputs.new_goal = navigation::NavGoal{pending_.goal_id, pending_.goal, false};
    inputs.cancel = pending_.kind == exploration::GoalCommand::Kind::kCancel;
    if (inputs.new_goal) goal_ = inputs.new_goal;
    if (gives_way_ && inputs.localized) inputs.order = giveWay();
    pending_ = {};
    navigation_ = navigator_.update(inputs, now());
    noteGoals(navigation_);
  }
  if (!navigation_.command) return;
  const Stopwatch watch(wall_clock_, times_.arbiter);
  if (const auto twist = arbiter_.onCommand(nav_source_, *navigation_.command, instant())) {
    simulator_.setCommand(robot_, *twist);
    mix(twist->linear);
    mix(twist->angular);
  }
}

navigation::NavOrder RobotStack::giveWay() {
  fleet::TrafficInputs inputs;
  inputs.T_map_base = lastPose().pose;
  if (goal_) inputs.goal = goal_->T_map_goal.position();
  inputs.path = navigator_.wayAhead();
  inputs.aside_failed = navigation_.aside_failed;
  inputs.map = &view();
  inputs.T_map_common = T_common_map_.inverse();
  return rule_.update(inputs, now()).forNavigator();
}

void RobotStack::noteGoals(const navigation::NavigatorOutput& output) {
  for (const navigation::NavFinished& finished : output.finished) {
    if (goal_ && goal_->id == finished.id) goal_.reset();
    goal_events_.push_back({static_cast<std::uint32_t>(finished.id), eventKind(finished), toString(finished.reason)});
    log("goal " + std::to_string(finished.id) + " " + toString(finished.result) + ": " + toString(finished.reason));
  }
}

void RobotStack::log(const std::string& line) {
  std::ostringstream out;
  out.precision(2);
  out << std::fixed << toSeconds(now()) << " " << line;
  log_.push_back(out.str());
}

std::vector<std::string> RobotStack::takeLog() {
  std::vector<std::string> out;
  out.swap(log_);
  return out;
}

void RobotStack::mix(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  hash_ = (hash_ ^ bits) * 1099511628211ULL;
}

}  // namespace frontier_pilot::system
