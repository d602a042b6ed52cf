#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/grids/ray_casting.h"
#include "frontier_pilot/sim/parameters.h"
#include "sim/disc_index.h"
#include "sim/lidar.h"
#include "sim/simulated_robot.h"

namespace frontier_pilot::sim {

/// The scanners of all robots of one kind. They measure at the same times: all beams at once, or, if they are rolling,
/// one beam after the other over the whole period of a scan. [SIM-2] [SCN-1]
class Scanners {
 public:
  /// `kind`: the index of the robots' kind. `step`: that of the simulation.
  Scanners(std::size_t kind, Duration step, const ScannerModel& scanner, const LidarNoise& noise);

  /// Prepares the scans of a robot of this kind.
  void mountOn(SimulatedRobot& robot) const { lidar_.describe(robot.unfinished); }
  /// Measures what has become due in the step that ends at `now`, for those of `robots` that are of this kind.
  void measure(Time now, std::vector<SimulatedRobot>& robots, const grids::RayCaster& walls, const DiscIndex& discs);
  /// Whether scans were completed in the last step.
  bool haveScanned() const { return have_scanned_; }

 private:
  /// What a measurement needs to know.
  struct Scene {
    std::vector<SimulatedRobot>& robots;
    const grids::RayCaster& walls;
    const DiscIndex& discs;
  };

  bool scan(Time now, const Scene& scene);
  bool sweep(Time now, const Scene& scene);
  void sweepUpTo(std::size_t end, Time now, const Scene& scene);
  template <class Visit>
  void forEach(std::vector<SimulatedRobot>& robots, Visit&& visit) const {
    for (SimulatedRobot& robot : robots) {
      if (robot.kind == kind_) visit(robot);
    }
  }

  std::size_t kind_;
  Duration step_;
  Lidar lidar_;
  bool rolling_;
  Duration period_;
  Duration beam_period_;  ///< from one beam to the next of a rolling scan
  Time begin_{};          ///< of the rolling scan that is being measured
  std::size_t next_beam_ = 0;
  Time next_scan_;
  bool have_scanned_ = false;
};

}  // namespace frontier_pilot::sim
