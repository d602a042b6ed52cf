#pragma once

#include <string>

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/mapping/mapper.h"
#include "frontier_pilot/mapping/odometry_anchor.h"
#include "frontier_pilot/mapping/parameters.h"
#include "frontier_pilot/mapping/scan_pairing.h"
#include "ros/common/names.h"

namespace frontier_pilot {

/// The parameters of the node `mapper`.
struct MapperNodeParameters {
  std::string map_frame = names::kMapFrame;
  std::string odom_frame;        ///< empty: the robot's
  std::string base_frame;        ///< empty: the robot's
  std::string map_file;          ///< loaded at the start; empty: none
  double autosave_period = 2.0;  ///< between two copies of the map for a restart after a crash [s]; 0: none is kept
  double update_period = 0.2;    ///< between two `map_updates` [s]
  double tf_period = 0.05;       ///< between two `map -> odom` [s]
  double tf_lead = 0.1;          ///< how far `map -> odom` is stamped ahead, so that it holds until the next one [s]
  double silence = 2.0;          ///< time without a scan put into the map after which the diagnostics warn [s]
  mapping::MapperParameters mapper;
  mapping::OdometryAnchorParameters odometry;
  mapping::ScanPairingParameters pairing;
  mapping::MapScheduleParameters publishing;

  template <class Visitor>
  void describe(Visitor& v) {
    describeRobot(v, mapper.robot);
    v.field("map_frame", map_frame, "", "frame of the map", FrameName::kGiven);
    v.field("odom_frame", odom_frame, "", "frame of odometry; empty: robot/odom_frame", FrameName::kMayBeEmpty);
    v.field("base_frame", base_frame, "", "frame of the robot; empty: robot/base_frame", FrameName::kMayBeEmpty);
    v.field("map_file", map_file, "", "saved map to begin with; empty: begin with an empty map");
    v.field("autosave_period", autosave_period, "s",
            "least time between two copies of the map, for a restart after a crash; 0: none", between(0.0, 3600.0));
    v.field("localize_only", mapper.localize_only, "",
            "leave the loaded map as it is, and only localise the robot in it");
    v.field("update_period", update_period, "s", "time between two map updates", tickPeriod());
    v.fixed({"tf_period"});
    v.field("tf_lead", tf_lead, "s", "time by which the stamp of map -> odom is ahead of the clock", timeSpanOrNone());
    v.field("silence", silence, "s", "time without a scan added to the map before the diagnostics warn", timeSpan());
    v.group("mapper", mapper, "the mapper");
    v.group("odometry", odometry, "which odometry is credible");
    v.group("pairing", pairing, "how scans are paired with odometry");
    v.group("publishing", publishing, "when the whole map is published");
  }
  void check(Problems& problems) const;
};

}  // namespace frontier_pilot
