#include "frontier_pilot/system/closed_loop.h"

#include <algorithm>
#include <utility>

#include "system/robot_stack.h"
#include "system/stopwatch.h"

namespace frontier_pilot::system {
namespace {

constexpr std::uint64_t kStepsPerControl = 10;   // the explorer's and the navigator's 10 Hz
constexpr std::uint64_t kStepsPerMessage = 100;  // maps and claims go to the others at 1 Hz
constexpr std::uint64_t kStepsPerMotion = 50;    // who goes where at 2 Hz
constexpr std::uint64_t kStepsPerTick = 5;       // the arbiter's 20 Hz

void add(const ModuleTimes& times, ModuleTimes& sum) {
  sum.mapper += times.mapper;
  sum.navigator += times.navigator;
  sum.explorer += times.explorer;
  sum.arbiter += times.arbiter;
  sum.decisions.insert(sum.decisions.end(), times.decisions.begin(), times.decisions.end());
}

}  // namespace

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
      agree_(parameters.agree),
      give_way_(parameters.give_way),
      wall_clock_(wall_clock) {
  for (std::size_t robot = 0; robot < simulator_.robotCount(); ++robot) {
    stacks_.push_back(std::make_unique<RobotStack>(simulator_, robot, parameters, wall_clock));
  }
}

ClosedLoop::~ClosedLoop() = default;

void ClosedLoop::step() {
  {
    const Stopwatch watch(wall_clock_, simulator_time_);
    simulator_.step();
  }
  ++steps_;
  const auto forEach = [this](void (RobotStack::*action)()) {
    for (const auto& stack : stacks_) {
      if (stack->powered()) ((*stack).*action)();
    }
  };
  forEach(&RobotStack::sense);
  if (steps_ % kStepsPerMessage == 0 && agree_) shareClaims();
  if (steps_ % kStepsPerMotion == 0 && give_way_ && stacks_.size() > 1) shareMotions();
  if (steps_ % kStepsPerControl == 0) {
    shareMaps();
    forEach(&RobotStack::control);
  }
  if (steps_ % kStepsPerTick == 0) forEach(&RobotStack::arbitrate);
}

/// Each robot follows its own map at once, and those of the others once a second, as they are published.
void ClosedLoop::shareMaps() {
  for (const auto& stack : stacks_) stack->followMapper();
  if (steps_ % kStepsPerMessage != 0) return;
  for (std::size_t source = 0; source < stacks_.size(); ++source) {
    const std::vector<CellRect> changed = stacks_[source]->publishMap();
    if (!changed.empty()) shareMap(source, changed);
  }
}

void ClosedLoop::shareMap(std::size_t source, const std::vector<CellRect>& changed) {
  for (std::size_t robot = 0; robot < stacks_.size(); ++robot) {
    if (robot == source) continue;
    const Pose2 T_map_source = simulator_.startPose(robot).inverse() * simulator_.startPose(source);
    stacks_[robot]->mergeMap(source, stacks_[source]->published(), changed, T_map_source);
  }
}

/// The frame in common is the map frame of the first robot.
void ClosedLoop::shareClaims() {
  std::vector<fleet::ClaimsMessage> messages;
  for (const auto& stack : stacks_) {
    if (stack->powered()) messages.push_back(stack->claims());
  }
  for (const fleet::ClaimsMessage& message : messages) {
    for (const auto& stack : stacks_) stack->hear(message);
  }
}

void ClosedLoop::shareMotions() {
  for (const auto& sender : stacks_) {
    const auto message = sender->powered() ? sender->motion() : std::nullopt;
    for (const auto& stack : stacks_) {
      if (message) stack->hear(*message);
    }
  }
}

void ClosedLoop::setPowered(std::size_t robot, bool on) { stacks_[robot]->setPowered(on); }
void ClosedLoop::setNavEnabled(bool on, std::size_t robot) { stacks_[robot]->setNavEnabled(on); }
const mapping::Mapper& ClosedLoop::mapper(std::size_t robot) const { return stacks_[robot]->mapper(); }
const OccupancyGrid& ClosedLoop::view(std::size_t robot) const { return stacks_[robot]->view(); }
const navigation::Navigator& ClosedLoop::navigator(std::size_t robot) const { return stacks_[robot]->navigator(); }
const navigation::NavigatorOutput& ClosedLoop::navigation(std::size_t robot) const {
  return stacks_[robot]->navigation();
}
const exploration::Explorer& ClosedLoop::explorer(std::size_t robot) const { return stacks_[robot]->explorer(); }
const exploration::ExplorerProgress& ClosedLoop::status(std::size_t robot) const { return stacks_[robot]->status(); }

bool ClosedLoop::done() const {
  return std::all_of(stacks_.begin(), stacks_.end(),
                     [](const auto& stack) { return !stack->powered() || stack->done(); });
}

std::vector<std::string> ClosedLoop::takeLog(std::size_t robot) { return stacks_[robot]->takeLog(); }

ModuleTimes ClosedLoop::times() const {
  ModuleTimes sum;
  sum.simulator = simulator_time_;
  for (const auto& stack : stacks_) add(stack->times(), sum);
  return sum;
}

std::uint64_t ClosedLoop::hash() const {
  std::uint64_t hash = stacks_.front()->hash();
  for (std::size_t robot = 1; robot < stacks_.size(); ++robot) {
    hash = (hash ^ stacks_[robot]->hash()) * 1099511628211ULL;
  }
  return hash;
}

}  // namespace frontier_pilot::system
