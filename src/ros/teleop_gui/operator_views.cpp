#include "ros/teleop_gui/operator_views.h"

#include <cmath>
#include <cstdio>

#include "frontier_pilot/core/outline.h"

namespace frontier_pilot {
namespace {

teleop::Severity severityOf(const ArbiterSource& source, bool robot_stands) {
  switch (source.state) {
    case ArbiterSource::ACTIVE:
      return robot_stands ? teleop::Severity::kIdle : teleop::Severity::kActive;
    case ArbiterSource::READY:
      return teleop::Severity::kGood;
    case ArbiterSource::REJECTED:
      return teleop::Severity::kError;
    case ArbiterSource::IDLE:
    case ArbiterSource::DISABLED:
      return teleop::Severity::kIdle;
    default:
      // Silence is an error only for a required source.
      return source.required ? teleop::Severity::kError : teleop::Severity::kIdle;
  }
}

/// The state in a few words: the age of the last message is shown beside it.
std::string stateText(const ArbiterSource& msg) {
  if (msg.state == ArbiterSource::NEVER_HEARD && msg.age < 0.0) return "no command received yet";
  return msg.state == ArbiterSource::STALE ? "stale" : msg.state_text;
}

teleop::SourceView toView(const ArbiterSource& msg, bool robot_stands, double status_age) {
  teleop::SourceView view;
  view.name = msg.name;
  view.state_text = stateText(msg);
  view.severity = severityOf(msg, robot_stands);
  view.enabled = msg.enabled != 0;
  view.required = msg.required != 0;
  view.priority = msg.priority;
  view.rate = msg.rate;
  view.rejected = msg.rejected;
  const bool talks = msg.state >= ArbiterSource::IDLE;
  if (msg.age >= 0.0) view.age = msg.age + (talks ? 0.0 : status_age);
  if (msg.publishers.size() > 1) {
    view.severity = teleop::Severity::kWarning;
    view.state_text += ", " + std::to_string(msg.publishers.size()) + " publishers";
  }
  return view;
}

/// Whether no source drives, or the one that does commands zero velocity.
bool stands(const ArbiterStatus& msg) {
  return msg.active_source.empty() || Twist2{msg.command.linear.x, msg.command.angular.z}.isZero();
}

teleop::Severity severityOf(const ArbiterStatus& msg) {
  const bool may_drive = msg.state == ArbiterStatus::IDLE || msg.state == ArbiterStatus::DRIVING;
  if (msg.emergency_stop || !may_drive) return teleop::Severity::kError;
  if (!msg.problems.empty()) return teleop::Severity::kWarning;
  return stands(msg) ? teleop::Severity::kIdle : teleop::Severity::kGood;
}

teleop::Severity severityOf(const AvoiderStatus& msg) {
  switch (msg.state) {
    case AvoiderStatus::CLEAR:
      return teleop::Severity::kGood;
    case AvoiderStatus::REVERSE:
    case AvoiderStatus::ROTATE:
      return teleop::Severity::kActive;
    case AvoiderStatus::WAITING:
      return teleop::Severity::kWarning;
    case AvoiderStatus::FAULT:
    case AvoiderStatus::STUCK:
      return teleop::Severity::kError;
    default:
      return teleop::Severity::kIdle;
  }
}

/// Nothing for a distance that the avoider does not know (NaN).
std::optional<double> known(double distance) {
  return std::isnan(distance) ? std::nullopt : std::optional<double>(distance);
}

teleop::Severity severityOf(const ExplorerStatus& msg) {
  switch (msg.reason) {
    case ExplorerStatus::NAVIGATION_GONE:
    case ExplorerStatus::NAVIGATION_UNABLE:
    case ExplorerStatus::MAP_GONE:
    case ExplorerStatus::POSE_GONE:
    case ExplorerStatus::ODOMETRY_GONE:
    case ExplorerStatus::ROBOT_OFF_KNOWN_GROUND:
    case ExplorerStatus::ROBOT_OUT_OF_BOUNDS:
      return teleop::Severity::kError;
    case ExplorerStatus::WAITING_FOR_INPUTS:
    case ExplorerStatus::NAVIGATION_DISABLED:
    case ExplorerStatus::ALL_BLACKLISTED:
      return teleop::Severity::kWarning;
    default:
      break;
  }
  if (msg.state == ExplorerStatus::DONE) return teleop::Severity::kGood;
  return msg.state == ExplorerStatus::IDLE ? teleop::Severity::kIdle : teleop::Severity::kActive;
}

std::string number(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Whether it has not explored since its start or its last reset.
bool isNew(const ExplorerStatus& msg) {
  return msg.reason == ExplorerStatus::PAUSED && msg.goals_sent == 0 && msg.frontiers_found == 0;
}

/// The state in words, where the one of the status would not say what the operator wants to know.
std::string stateText(const ExplorerStatus& msg) {
  if (msg.state != ExplorerStatus::IDLE) return msg.state_text;
  if (msg.reason != ExplorerStatus::PAUSED) return "Waiting";
  return isNew(msg) ? "Not started" : "Paused";
}

/// The reason, or what to do where the state has said the reason already.
std::string reasonText(const ExplorerStatus& msg) {
  if (isNew(msg)) return "Start lets the robot explore.";
  const bool is_plainly_paused = msg.reason == ExplorerStatus::PAUSED && msg.reason_text == "paused";
  return is_plainly_paused ? "Start lets it go on." : msg.reason_text;
}

std::string boundsText(const ExplorerStatus& msg) {
  const std::size_t clicked = msg.clicked_corners.points.size();
  if (clicked > 0) return std::to_string(clicked) + (clicked == 1 ? " corner clicked" : " corners clicked");
  std::vector<Vec2> corners;
  for (const geometry_msgs::Point32& point : msg.stay_within.points) corners.emplace_back(point.x, point.y);
  const std::size_t areas = msg.keep_out.size();
  if (corners.empty() && areas == 0) return "none";
  std::string out = areas == 0 ? "" : std::to_string(areas) + (areas == 1 ? " area left out" : " areas left out");
  if (corners.empty()) return out;
  const double area = polygonArea(corners);
  return number(area < 100.0 ? "within %.1f m²" : "within %.0f m²", area) + (out.empty() ? "" : ", " + out);
}

std::string inspectText(const ExplorerStatus& msg) {
  const std::size_t waiting = msg.to_inspect.size();
  if (waiting == 0 && msg.inspected == 0 && msg.inspections_failed == 0) return "nothing";
  std::string text = std::to_string(waiting) + " to go, " + std::to_string(msg.inspected) + " done";
  if (msg.inspections_failed > 0) text += ", " + std::to_string(msg.inspections_failed) + " given up";
  return text;
}

/// When the exploration ends, and the charge if it is known.
std::string endText(const ExplorerStatus& msg) {
  const std::string when = "when " + (msg.until.empty() ? std::string("nothing is left") : msg.until);
  return std::isnan(msg.battery) ? when : when + number("; battery %.0f %%", 100.0 * msg.battery);
}

std::string mapText(const ExplorerStatus& msg) {
  if (!msg.map_saved.empty()) return msg.map_saved;
  return msg.save_map_at_end.empty() ? "not saved by the explorer" : "saved at the end: " + msg.save_map_at_end;
}

teleop::SectorView toSectorView(const avoid::Sector& sector, double stop, double clear) {
  return {sector.from, sector.to, stop, clear};
}

}  // namespace

teleop::ArbiterView toView(const ArbiterStatus& msg, double status_age) {
  teleop::ArbiterView view;
  view.status_age = status_age;
  view.severity = severityOf(msg);
  view.summary = msg.summary;
  view.active_source = msg.active_source;
  view.stop_cause = msg.emergency_stop_cause;
  view.stops = msg.stops;
  view.problems = msg.problems;
  view.command = {msg.command.linear.x, msg.command.angular.z};
  for (const ArbiterSource& source : msg.sources) view.sources.push_back(toView(source, stands(msg), status_age));
  return view;
}

teleop::AvoiderView toView(const AvoiderStatus& msg, double status_age) {
  teleop::AvoiderView view;
  view.status_age = status_age;
  view.severity = severityOf(msg);
  view.enabled = msg.state != AvoiderStatus::IDLE;
  view.state_text = msg.summary.empty() ? msg.reason : msg.summary;
  view.summary = msg.summary;
  view.front_left = known(msg.front_left);
  view.front_right = known(msg.front_right);
  view.rear = known(msg.rear);
  return view;
}

teleop::ExplorerView toView(const ExplorerStatus& msg, double status_age) {
  teleop::ExplorerView view;
  view.status_age = status_age;
  view.severity = severityOf(msg);
  view.running = msg.state != ExplorerStatus::DONE && msg.reason != ExplorerStatus::PAUSED;
  view.state_text = stateText(msg);
  const bool explores = msg.state != ExplorerStatus::IDLE && msg.state != ExplorerStatus::DONE;
  if (explores) view.phase_text = msg.phase_text;
  view.not_started = isNew(msg);
  view.reason_text = reasonText(msg);
  view.frontiers_found = msg.frontiers_found;
  view.frontiers_selectable = msg.frontiers_selectable;
  view.frontiers_blacklisted = msg.frontiers_blacklisted;
  view.goals_sent = msg.goals_sent;
  view.goals_reached = msg.goals_reached;
  view.goals_failed = msg.goals_failed;
  const unsigned under_way = msg.state == ExplorerStatus::NAVIGATING ? 1 : 0;
  const unsigned ended = msg.goals_reached + msg.goals_failed + under_way;
  view.goals_dropped = msg.goals_sent > ended ? msg.goals_sent - ended : 0;
  view.explored_area = msg.explored_area;
  view.share_explored = msg.state == ExplorerStatus::DONE ? std::nullopt : known(msg.share_explored);
  view.distance_travelled = msg.distance_travelled;
  view.return_to_start = msg.return_to_start != 0;
  view.bounded = !msg.stay_within.points.empty() || !msg.keep_out.empty() || !msg.clicked_corners.points.empty();
  view.bounds_text = boundsText(msg);
  view.inspections_wait = !msg.to_inspect.empty();
  view.inspect_text = inspectText(msg);
  view.end_text = endText(msg);
  view.map_text = mapText(msg);
  return view;
}

teleop::NavigationView toView(const NavigatorProgress& msg, double status_age) {
  teleop::NavigationView view;
  view.status_age = status_age;
  view.status = msg.status;
  view.has_goal = msg.has_goal != 0;
  if (!view.has_goal) return view;
  const bool is_hindered = msg.status.rfind("recovering", 0) == 0 || msg.status.rfind("waiting", 0) == 0;
  view.severity = is_hindered ? teleop::Severity::kWarning : teleop::Severity::kActive;
  view.goal = Vec2(msg.goal.position.x, msg.goal.position.y);
  view.distance_left = known(msg.distance_left);
  view.time_left = known(msg.time_left);
  return view;
}

avoid::AvoiderParameters tuned(const avoid::AvoiderParameters& before, const dynamic_reconfigure::Config& msg) {
  ParameterMap changes;
  for (const dynamic_reconfigure::DoubleParameter& value : msg.doubles) {
    for (const char* distance : {"stop_distance", "clear_distance", "rear_stop_distance"})
      if (value.name == distance) changes[distance] = {value.value};
  }
  avoid::AvoiderParameters after = before;
  return loadParameters(changes, after).empty() ? after : before;
}

teleop::AvoiderSectors toSectors(const avoid::AvoiderParameters& parameters) {
  const avoid::AvoiderDistances distances(parameters);
  return {toSectorView(parameters.front_left, distances.stop, distances.clear),
          toSectorView(parameters.front_right, distances.stop, distances.clear),
          toSectorView(parameters.rear, distances.rear_stop, distances.rear_stop)};
}

}  // namespace frontier_pilot
