#pragma once

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot::occupancy {

/// The inverse sensor model: how one scan changes the probability of a cell, and the bounds of that, which let the map
/// still adapt to changes. Hornung et al., "OctoMap", Autonomous Robots 34, 2013, eq. 2-4.
struct OccupancyModel {
  double hit = 0.7;         ///< probability that a cell is occupied, given that a beam ended in it
  double miss = 0.4;        ///< probability that a cell is occupied, given that a beam passed it
  double clamp_min = 0.12;  ///< least probability a cell may reach
  double clamp_max = 0.97;  ///< greatest probability a cell may reach

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("hit", hit, "", "probability of occupied, given that a beam ended in the cell", {0.5, 0.999, true});
    v.field("miss", miss, "", "probability of occupied, given that a beam passed the cell", between(0.001, 0.499));
    v.field("clamp_min", clamp_min, "", "least probability that a cell may reach", between(0.001, 0.499));
    v.field("clamp_max", clamp_max, "", "greatest probability that a cell may reach", {0.5, 0.999, true});
  }
};

/// The map and its octree.
struct OccupancyMapParameters {
  double resolution = 0.05;      ///< side of a cell [m]
  double scanner_height = 0.18;  ///< height of the mapped layer [m]
  double growth_step = 10.0;     ///< the map grows by multiples of this [m]
  double max_side = 1000.0;      ///< the map never gets wider or higher than this [m]
  double max_memory = 256.0;     ///< the cells of the map never take more than this [MB]
  bool probabilities = false;    ///< project probabilities, not just free and occupied
  OccupancyModel model;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("resolution", resolution, "m", "side of a cell", between(bounds::kLeastResolution, 1.0));
    v.field("scanner_height", scanner_height, "m", "height of the layer in the octree", between(0.0, 10.0));
    v.fixed({"growth_step"});
    v.field("max_side", max_side, "m", "the map never gets wider or higher than this", between(10.0, 1000.0));
    v.field("max_memory", max_memory, "MB",
            "most memory for the cells, 4 bytes each; beyond it nothing new is mapped. While the map is rendered again "
            "there are two",
            between(1.0, 16000.0));
    v.fixed({"probabilities"});
    v.group("model", model, "inverse sensor model");
  }
};

/// How a scan is inserted into the map, see ScanInserter.
struct ScanInsertionParameters {
  double max_clear_range = 8.0;  ///< a beam without a return clears at most this far [m]
  double robot_radius = 0.105;   ///< radius of the free disc under the robot [m]; set by the mapper from its robot
  double hit_offset = 0.5;       ///< distance of a hit behind the measured surface [cells]
  double clear_margin = 0.3;     ///< a beam clears the cells up to this distance before the surface [cells]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("max_clear_range", max_clear_range, "m", "a beam without a return clears at most this far", scanRange());
    v.moved("robot_radius", "robot/disc_radius or robot/outline");
    v.fixed({"hit_offset", "clear_margin"});
  }
};

}  // namespace frontier_pilot::occupancy
