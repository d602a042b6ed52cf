#include "support/closed_loop/guided_drive.h"

#include <algorithm>
#include <stdexcept>

namespace frontier_pilot::test {
namespace {

constexpr int kStepsPerControl = 10;
constexpr double kRoom = 0.3;     // [m], from a place to the nearest wall
constexpr double kArrived = 0.3;  // [m]
constexpr int kPatience = 20;     // control cycles on a path that is blocked
constexpr int kTries = 1000;
constexpr int kStuck = 20000;  // steps without any motion

/// Plans only through places with full clearance, because the follower gets no scan that would show it the walls.
planning::ClearanceParams roomy(const sim::SimulatorParameters& parameters) {
  planning::ClearanceParams params;
  params.inscribed_radius = parameters.robot.drivenOutline().circumscribedRadius();
  params.tight_weight = 0.0;
  return params;
}

}  // namespace

GuidedDrive::GuidedDrive(sim::World world, const sim::SimulatorParameters& parameters, double distance)
    : simulator_(std::move(world), parameters),
      clearance_(roomy(parameters)),
      follower_({}, parameters.robot),
      wanted_distance_(distance),
      last_(simulator_.pose(0).position()) {
  // Unknown cells count as walls here.
  OccupancyGrid truth = simulator_.map();
  std::replace_if(truth.cells().begin(), truth.cells().end(), isUnknown, kOccupied);
  clearance_.setMap(truth, truth.geometry().rect());
  clearance_.refresh();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Cell cell = truth.geometry().cell(i);
    if (clearance_.isPassable(cell) && clearance_.field()[cell] > kRoom) places_.push_back(cell);
  }
  headForNextPlace();
}

const LaserScan2* GuidedDrive::nextScan() {
  while (distance_ < wanted_distance_) {
    if (steps_ - moved_ > kStuck)
      throw std::runtime_error("the drive is stuck: the ways are too narrow for its follower");
    if (steps_++ % kStepsPerControl == 0) steer();
    simulator_.step();
    truth_.add(now(), T_map_base());
    odometry_.add(now(), T_odom_base());
    const double moved = (simulator_.pose(0).position() - last_).norm();
    if (moved > 0.0) moved_ = steps_;
    distance_ += moved;
    last_ = simulator_.pose(0).position();
    if (const LaserScan2* scan = simulator_.newScan(0)) return scan;
  }
  return nullptr;
}

void GuidedDrive::steer() {
  if (follower_.remaining() < kArrived || blocked_ > kPatience) headForNextPlace();
  static const navigation::ScanPoints kNothingSeen;
  const navigation::FollowerOutput output =
      follower_.update({simulator_.pose(0), simulator_.velocity(0), 0.0, kNothingSeen, clearance_});
  blocked_ = output.blocked ? blocked_ + 1 : 0;
  simulator_.setCommand(0, output.command);
}

void GuidedDrive::headForNextPlace() {
  const Vec2 here = simulator_.pose(0).position();
  for (int i = 0; i < kTries && !places_.empty(); ++i) {
    const auto place = static_cast<std::size_t>(random_.uniform() * static_cast<double>(places_.size()));
    planning::PlanRequest request;
    request.start = here;
    request.goal = clearance_.geometry().centre(places_[place]);
    planning::PlanResult plan = planner_.plan(clearance_, request);
    if (plan.found() && plan.path.length() > kArrived) return follower_.setPath(std::move(plan.path));
  }
  throw std::runtime_error("there is nowhere to drive to from the start");
}

}  // namespace frontier_pilot::test
