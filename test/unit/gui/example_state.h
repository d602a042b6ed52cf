#pragma once

#include <cmath>
#include <limits>

#include "teleop/operator_state.h"

namespace frontier_pilot::test {

inline teleop::SourceView exampleSource(const char* name, int priority, teleop::Severity severity, const char* text) {
  teleop::SourceView source;
  source.name = name;
  source.priority = priority;
  source.severity = severity;
  source.state_text = text;
  source.enabled = source.service_up = true;
  return source;
}

/// A scan of a room of 5 m by 3.4 m with a pillar ahead on the left.
inline LaserScan2 exampleScan() {
  LaserScan2 scan;
  scan.angle_min = -kPi;
  scan.angle_increment = 2.0 * kPi / 360.0;
  scan.range_min = 0.12;
  scan.range_max = 3.5;
  for (std::size_t beam = 0; beam < 360; ++beam) {
    const double angle = scan.angle(beam), c = std::cos(angle), s = std::sin(angle);
    double range = std::min(c > 0 ? 3.1 / c : -1.9 / c, s > 0 ? 1.9 / s : -1.5 / s);
    if (std::abs(angleDifference(angle, 0.5)) < 0.14) range = std::min(range, 1.1);
    if (std::abs(angleDifference(angle, -2.2)) < 0.25) range = std::numeric_limits<double>::infinity();
    scan.ranges.push_back(static_cast<float>(range));
  }
  return scan;
}

/// A system in the middle of an exploration: everything is up, nav drives.
inline teleop::OperatorState exampleState() {
  teleop::OperatorState state;
  state.connected = true;
  state.emergency_stop = false;
  state.stop_service_up = state.clear_service_up = true;
  teleop::ArbiterView arbiter;
  arbiter.severity = teleop::Severity::kGood;
  arbiter.summary = "nav drives at 0.18 m/s, 0.31 rad/s";
  arbiter.active_source = "nav";
  arbiter.command = {0.18, 0.31};
  arbiter.sources = {exampleSource("avoid", 100, teleop::Severity::kGood, "alive, asks for nothing"),
                     exampleSource("behavior", 90, teleop::Severity::kIdle, "never heard"),
                     exampleSource("patrol", 80, teleop::Severity::kWarning, "stale"),
                     exampleSource("nav", 60, teleop::Severity::kActive, "drives"),
                     exampleSource("manual", 40, teleop::Severity::kGood, "ready")};
  for (const std::size_t i : {0U, 3U, 4U}) {
    arbiter.sources[i].rate = 10.0;
    arbiter.sources[i].age = 0.02 + 0.01 * static_cast<double>(i);
  }
  arbiter.sources[0].required = true;
  arbiter.sources[2].age = 74.0;
  state.arbiter = arbiter;
  state.avoider_service_up = true;
  state.avoider = teleop::AvoiderView{0.2, teleop::Severity::kGood, true, "clear", "nothing near", 1.1, 1.73, 1.9};
  state.sectors = {teleop::SectorView{0.0, kPi / 3, 0.5, 0.65}, teleop::SectorView{-kPi / 3, 0.0, 0.5, 0.65},
                   teleop::SectorView{2 * kPi / 3, -2 * kPi / 3, 0.25, 0.25}};
  state.explorer_service_up = state.explorer_reset_up = true;
  state.explorer_bounds_up = state.explorer_inspections_up = state.explorer_return_up = true;
  teleop::ExplorerView explorer;
  explorer.severity = teleop::Severity::kActive;
  explorer.running = true;
  explorer.state_text = "NAVIGATING";
  explorer.phase_text = "COVERAGE";
  explorer.reason_text = "goal sent: 8.2 m away, 14.6 m² to see";
  explorer.frontiers_found = 31;
  explorer.frontiers_selectable = 24;
  explorer.goals_sent = 42;
  explorer.goals_dropped = 29;
  explorer.goals_reached = 12;
  explorer.share_explored = 0.61;
  explorer.explored_area = 387.4;
  explorer.distance_travelled = 212.7;
  explorer.bounded = true;
  explorer.bounds_text = "within 640 m², 1 area left out";
  explorer.inspections_wait = true;
  explorer.inspect_text = "2 to go, 1 done";
  explorer.end_text = "when the battery is at 20 %; battery 57 %";
  explorer.map_text = "saved at the end: maps/hall";
  state.explorer = explorer;
  state.patrol.server_up = state.spin.server_up = state.navigate.server_up = true;
  state.patrol.result = "square patrol complete!!";
  state.scan = teleop::ScanView{0.06, exampleScan()};
  return state;
}

}  // namespace frontier_pilot::test
