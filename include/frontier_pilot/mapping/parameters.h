#pragma once

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/occupancy/parameters.h"
#include "frontier_pilot/slam/parameters.h"

namespace frontier_pilot::mapping {

/// When the whole map is sent, see MapSchedule.
struct MapScheduleParameters {
  double min_period = 1.0;  ///< least time between two whole maps [s]
  double max_period = 5.0;  ///< time after which a whole map follows changes; 12 times as long while they are few [s]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("min_period", min_period, "s", "least time between two whole maps", timeSpan());
    v.field("max_period", max_period, "s",
            "time after which a whole map follows changes; 12 times as long while they are few", timeSpan());
  }
};

/// Which motion of odometry is credible, see OdometryAnchor.
struct OdometryAnchorParameters {
  double max_speed = 2.0;       ///< greatest credible speed of odometry [m/s]
  double max_turn_rate = 10.0;  ///< greatest credible rate of turn of odometry [rad/s]
  bool trusted = false;         ///< jumps are real: the robot was moved; set from the mapper's `trust_odometry`

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("max_speed", max_speed, "m/s", "greatest credible speed between two messages; more is a jump of odometry",
            positiveUpTo(1000.0));
    v.field("max_turn_rate", max_turn_rate, "rad/s",
            "greatest credible rate of turn between two messages; more is a jump of odometry", positiveUpTo(1000.0));
  }
};

/// How much odometry is kept.
struct OdometryBufferParameters {
  double length = 5.0;   ///< how long a pose is kept [s]
  double max_gap = 0.5;  ///< poses farther apart are not interpolated between [s]

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"length", "max_gap"});
  }
};

/// How scans find their odometry, see ScanPairing.
struct ScanPairingParameters {
  double patience = 0.3;  ///< how long a scan waits for its odometry [s]
  int max_waiting = 20;   ///< greatest number of scans that wait
  OdometryBufferParameters odometry;

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"patience", "max_waiting"});
    v.group("odometry", odometry, "odometry buffer");
  }
};

/// The mapper and all its parts.
struct MapperParameters {
  RobotModel robot;              ///< cells under it are mapped as free; described by the node, as `robot`
  double max_age = 1.0;          ///< an older scan is stale [s]
  double max_lead = 0.5;         ///< a scan may be this much ahead of the clock [s]
  double min_travel = 0.01;      ///< a robot that moved less has not moved [m]
  double min_rotation = 0.01;    ///< a robot that turned less has not turned [rad]
  double standing_period = 0.2;  ///< time between scans used while the robot stands [s]
  bool trust_odometry = false;   ///< take odometry for the truth: no matching, no loops
  bool localize_only = false;    ///< leave the map as it was loaded; described by the node, as `localize_only`
  occupancy::OccupancyMapParameters map;
  occupancy::ScanInsertionParameters insertion;
  slam::GraphSlamParameters slam;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("max_age", max_age, "s", "an older scan is stale", timeSpan());
    v.fixed({"max_lead"});
    v.field("min_travel", min_travel, "m", "a robot that moved less since the last scan stands", between(0.0, 10.0));
    v.fixed({"min_rotation", "standing_period"});
    v.field("trust_odometry", trust_odometry, "", "take odometry for the truth: no scan matching, no loop closing");
    v.group("map", map, "the map and its octree");
    v.group("insertion", insertion, "how a scan goes into the map");
    v.group("slam", slam, "scan matching and loop closing");
  }
};

}  // namespace frontier_pilot::mapping
