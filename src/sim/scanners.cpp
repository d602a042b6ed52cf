#include "sim/scanners.h"

#include <algorithm>
#include <cstdint>

namespace frontier_pilot::sim {

Scanners::Scanners(std::size_t kind, Duration step, const ScannerModel& scanner, const LidarNoise& noise)
    : kind_(kind),
      step_(step),
      lidar_(scanner, noise),
      rolling_(scanner.rolling),
      period_(fromSeconds(1.0 / scanner.rate)),
      beam_period_(std::max(Duration(1), period_ / scanner.beams)),
      next_scan_(Time{} + period_) {}

void Scanners::measure(Time now, std::vector<SimulatedRobot>& robots, const grids::RayCaster& walls,
                       const DiscIndex& discs) {
  const Scene scene{robots, walls, discs};
  have_scanned_ = rolling_ ? sweep(now, scene) : scan(now, scene);
}

// Measures scans whose beams are simultaneous, if they are due. Returns whether they are.
bool Scanners::scan(Time now, const Scene& scene) {
  if (now < next_scan_) return false;
  next_scan_ = std::max(next_scan_ + period_, now);
  forEach(scene.robots, [&](SimulatedRobot& robot) {
    robot.scan.stamp = now;
    lidar_.scan(robot.pose, scene.walls, scene.discs, robot.disc, robot.lidar_noise, robot.scan);
  });
  return true;
}

// Measures the beams of rolling scans whose time has come. Returns whether scans have been completed.
bool Scanners::sweep(Time now, const Scene& scene) {
  bool completed = false;
  while (begin_ + static_cast<std::int64_t>(next_beam_) * beam_period_ <= now) {
    const auto due = static_cast<std::size_t>((now - begin_) / beam_period_) + 1;
    sweepUpTo(std::min(due, lidar_.beamCount()), now, scene);
    if (next_beam_ < lidar_.beamCount()) break;
    forEach(scene.robots, [&](SimulatedRobot& robot) {
      robot.unfinished.stamp = begin_;
      robot.scan = robot.unfinished;
    });
    begin_ += period_;
    next_beam_ = 0;
    completed = true;
  }
  return completed;
}

// The beams up to, but not including, `end`. During a step of the simulation a robot moves evenly from where it was to
// where it is; everything else is where it is at the end of the step.
void Scanners::sweepUpTo(std::size_t end, Time now, const Scene& scene) {
  const double per_beam = toSeconds(beam_period_) / toSeconds(step_);
  const Time first = begin_ + static_cast<std::int64_t>(next_beam_) * beam_period_;
  const double begin = 1.0 - toSeconds(now - first) / toSeconds(step_);
  forEach(scene.robots, [&](SimulatedRobot& robot) {
    const Vec2 moved = robot.pose.position() - robot.before.position();
    const double turned = angleDifference(robot.pose.yaw, robot.before.yaw);
    const Lidar::Sweep sweep{next_beam_, end, interpolate(robot.before, robot.pose, begin), per_beam * moved,
                             per_beam * turned};
    lidar_.measure(sweep, scene.walls, scene.discs, robot.disc, robot.lidar_noise, robot.unfinished);
  });
  next_beam_ = end;
}

}  // namespace frontier_pilot::sim
