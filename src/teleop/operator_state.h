#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/laser_scan.h"

/// What an operator is shown, as plain data without ROS or Qt. A part of which nothing was received is empty; the
/// others carry their age [s], by steady time. No value is a placeholder.
namespace frontier_pilot::teleop {

/// How much attention something deserves.
enum class Severity : std::uint8_t { kIdle, kGood, kActive, kWarning, kError };

/// One source of velocity commands.
struct SourceView {
  std::string name;
  std::string state_text;  ///< the state in words
  Severity severity = Severity::kIdle;
  bool enabled = false;
  bool required = false;
  bool service_up = false;  ///< whether it can be switched now
  int priority = 0;
  std::optional<double> age;  ///< of its last message [s]
  double rate = 0.0;          ///< [Hz]
  std::uint64_t rejected = 0;
};

struct ArbiterView {
  double status_age = 0.0;
  Severity severity = Severity::kIdle;
  std::string summary;
  std::string active_source;  ///< empty: nobody
  std::string stop_cause;
  std::uint64_t stops = 0;  ///< asked for so far, also those while the robot was stopped already
  std::vector<std::string> problems;
  Twist2 command;  ///< what was last sent to the base
  std::vector<SourceView> sources;

  /// Who drives, as a whole statement; a source that drives may command zero velocity.
  std::string driver() const;
};

struct AvoiderView {
  double status_age = 0.0;
  Severity severity = Severity::kIdle;
  bool enabled = false;
  std::string state_text, summary;
  std::optional<double> front_left, front_right, rear;  ///< nearest obstacle [m]; infinite: nothing in range
};

/// A sector of the avoider, from `from` counter-clockwise to `to` [rad] in the base frame, and its distances.
struct SectorView {
  double from = 0.0, to = 0.0;
  double stop = 0.0;   ///< an obstacle nearer than this is too near [m]
  double clear = 0.0;  ///< the sector is clear if nothing is nearer than this [m]
};

/// Where the avoider looks; empty until its configuration is known.
struct AvoiderSectors {
  std::optional<SectorView> front_left, front_right, rear;
};

struct ExplorerView {
  double status_age = 0.0;
  Severity severity = Severity::kIdle;
  bool running = false;      ///< not paused and not done
  bool not_started = false;  ///< what it counts is not known yet
  std::string state_text, phase_text, reason_text;
  unsigned frontiers_found = 0, frontiers_selectable = 0, frontiers_blacklisted = 0;
  unsigned goals_sent = 0, goals_reached = 0, goals_failed = 0;
  double explored_area = 0.0;            ///< [m^2]
  double distance_travelled = 0.0;       ///< [m]
  std::optional<double> share_explored;  ///< of the whole floor, estimated
  unsigned goals_dropped = 0;            ///< on the way: nothing was left to see there, another was better, or a stop
  bool bounded = false;                  ///< bounds are in force, or are being drawn
  bool return_to_start = false;          ///< it drives back at the end
  bool inspections_wait = false;         ///< poses wait to be inspected on the way
  std::string bounds_text, inspect_text, end_text, map_text;
};

/// The goal of the navigation. Without one it is sent only when something changes; its age then says nothing.
struct NavigationView {
  double status_age = 0.0;
  Severity severity = Severity::kIdle;
  bool has_goal = false;
  Vec2 goal = Vec2::Zero();             ///< in the map's frame [m]
  std::optional<double> distance_left;  ///< along the path [m]; nothing: there is no path
  std::optional<double> time_left;      ///< [s]
  std::string status;                   ///< what it does and why; without a goal, how the last one ended
};

/// An action: a patrol, a spin, a goal of the navigation, or waypoints.
struct ActionView {
  bool connected = false;  ///< to a server, which may hang
  bool server_up = false;  ///< it responds
  bool active = false;
  bool own = false;      ///< with a goal that was sent here
  std::string feedback;  ///< of the present or last goal
  std::string result;    ///< of the last goal; empty while one is active
};

/// The answer to a request.
struct OperatorAnswer {
  std::uint64_t count = 0;  ///< of all answers so far; 0: there is none
  bool success = false;
  std::string text;
};

struct ScanView {
  double age = 0.0;
  LaserScan2 scan;
};

/// Everything at one moment.
struct OperatorState {
  bool connected = false;              ///< the ROS master answers
  std::optional<bool> emergency_stop;  ///< from the latched topic; nothing: not received yet
  bool stop_service_up = false, clear_service_up = false;
  std::string clear_refusal;    ///< why the last request to clear the stop was refused; empty: it was not
  std::optional<bool> contact;  ///< whether the robot touches something; nothing: it cannot tell
  std::optional<ArbiterView> arbiter;
  std::uint64_t arbiter_changes = 0;  ///< how often an arbiter was first heard, or has ended
  bool avoider_service_up = false;
  std::optional<AvoiderView> avoider;
  AvoiderSectors sectors;
  bool explorer_service_up = false, explorer_reset_up = false;
  bool explorer_bounds_up = false, explorer_inspections_up = false, explorer_return_up = false;
  std::optional<ExplorerView> explorer;
  std::optional<NavigationView> navigation;
  ActionView patrol, spin;
  ActionView navigate, waypoints;  ///< goals of all clients
  bool save_map_up = false, load_map_up = false;
  OperatorAnswer map_answer;  ///< to the last request to save or to load a map
  std::optional<ScanView> scan;

  /// The source of that name; nullptr where there is none.
  const SourceView* source(const std::string& name) const;
};

/// A status older than this [s] does not count: its sender, which should repeat it once a second, has died.
constexpr double kStatusLifetime = 3.0;

}  // namespace frontier_pilot::teleop
