#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/robot_model.h"

namespace frontier_pilot::arbiter {

/// One source of velocity commands. A configuration entry with the name of a built-in source starts with that source's
/// values, so that `{name: avoid, required: true}` changes a single one.
struct SourceParameters {
  std::string name;
  std::string topic;
  int priority = 0;
  double timeout = 1.0;
  bool enabled = true;
  bool zero_means_idle = false;
  bool required = false;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("name", name, "", "name of the source, as in the service set_<name>_enabled");
    startFromBuiltIn();
    v.field("topic", topic, "", "topic of its commands (geometry_msgs/Twist)");
    v.field("priority", priority, "", "the source with the highest priority drives; must be unique",
            between(-1e9, 1e9));
    v.field("timeout", timeout, "s", "greatest age of its last message, after which it is stale",
            Bounds{0.0, 3600.0, true});
    v.field("enabled", enabled, "", "whether the source is enabled at the start");
    v.field("zero_means_idle", zero_means_idle, "",
            "an all-zero message keeps the source alive without claiming the wheels");
    v.field("required", required, "", "while it is enabled but silent, lower sources may not drive forward");
  }

 private:
  /// Does nothing to a source that already has a topic.
  void startFromBuiltIn();
};

/// By descending priority: avoid, behavior, patrol, nav, manual. [ARB-1]
std::vector<SourceParameters> builtInSources();

/// The parameters of the arbiter.
struct ArbiterParameters {
  std::vector<SourceParameters> sources = builtInSources();
  RobotModel robot;  ///< commands are clamped to its limits
  double clear_quiet_time = 0.5;
  double clock_stall_time = 0.5;
  bool stand_when_contested = true;
  std::string fleet_stop_status;

  template <class Visitor>
  void describe(Visitor& v) {
    v.list("sources", sources, "the sources of commands; a list given here replaces the built-in one");
    describeRobot(v, robot);
    v.field("clear_quiet_time", clear_quiet_time, "s",
            "an emergency stop is not cleared while a non-zero command is younger than this", between(0.0, 60.0));
    v.field("clock_stall_time", clock_stall_time, "s",
            "ROS time that stands still for this long, by steady time, makes every source stale",
            Bounds{0.0, 60.0, true});
    v.field("stand_when_contested", stand_when_contested, "",
            "send zeros while another node offers one of the arbiter's services and could receive an emergency stop");
    v.field(
        "fleet_stop_status", fleet_stop_status, "",
        "topic on which fleet_stop says which robots it reaches; the diagnostics report an error while it is silent "
        "or does not reach this robot; empty: the robot belongs to no fleet");
    v.tunable({"limits/max_linear", "limits/max_angular"});
  }
  /// Names, topics and priorities must be unique, and no source may read `cmd_vel` itself.
  void check(Problems& problems) const;
};

}  // namespace frontier_pilot::arbiter
