#pragma once

#include <string>

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/exploration/parameters.h"
#include "ros/common/names.h"
#include "ros/frontier_explorer/team_claims.h"

namespace frontier_pilot {

/// The parameters of the node `frontier_explorer`.
struct ExplorerNodeParameters {
  bool autostart = false;
  double rate = 10.0;
  std::string map_frame = names::kMapFrame;
  std::string base_frame;       ///< empty: the robot's
  std::string save_map_at_end;  ///< path; empty: no
  FleetParameters fleet;
  exploration::ExplorerParameters explorer;

  template <class V>
  void describe(V& v) {
    v.field("autostart", autostart, "",
            "explore as soon as all inputs are available; false: wait for set_exploration_enabled");
    v.field("rate", rate, "Hz", "ticks of the explorer", tickRate());
    v.field("map_frame", map_frame, "", "frame of the map and of the goals", FrameName::kGiven);
    v.field("base_frame", base_frame, "", "frame of the robot; empty: robot/base_frame", FrameName::kMayBeEmpty);
    v.field("save_map_at_end", save_map_at_end, "",
            "when the exploration has ended, the mapper saves the map here (as mapper/save_map); a robot with a "
            "fleet/name appends it to the path; empty: the map is not saved");
    v.group("fleet", fleet, "other robots that explore the same building");
    explorer.describe(v);
  }
  void check(Problems& problems) const {
    explorer.check(problems);
    explorer.robot.checkIsNotBase(problems, "map_frame", map_frame, base_frame);
  }
};

}  // namespace frontier_pilot
