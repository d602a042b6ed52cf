#include "ros/frontier_explorer/explorer_status.h"

#include <cmath>
#include <limits>

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/throttled_log.h"
#include "ros/frontier_explorer/explorer_bounds.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"

namespace frontier_pilot {
namespace {

constexpr Duration kBatteryLifetime = std::chrono::minutes(1);  // some drivers report it only twice a minute
constexpr const char* kNoBattery = "no battery state is received";

}  // namespace

// The enumerations of the module have the same values as the constants of the message.
static_assert(static_cast<int>(exploration::ExplorerState::kDone) == ExplorerStatus::DONE);
static_assert(static_cast<int>(exploration::ExplorerPhase::kCoverage) == ExplorerStatus::COVERAGE);
static_assert(static_cast<int>(exploration::ExplorerReason::kPaused) == ExplorerStatus::PAUSED);
static_assert(static_cast<int>(exploration::ExplorerReason::kNavigationGone) == ExplorerStatus::NAVIGATION_GONE);
static_assert(static_cast<int>(exploration::ExplorerReason::kNoReachableFrontier) ==
              ExplorerStatus::NO_REACHABLE_FRONTIER);
static_assert(static_cast<int>(exploration::ExplorerReason::kAllBlacklisted) == ExplorerStatus::ALL_BLACKLISTED);
static_assert(static_cast<int>(exploration::ExplorerReason::kClockJumpedBack) == ExplorerStatus::CLOCK_JUMPED_BACK);
static_assert(static_cast<int>(exploration::ExplorerReason::kTooManyFrontiers) == ExplorerStatus::TOO_MANY_FRONTIERS);

static_assert(static_cast<int>(exploration::ExplorerReason::kUntilDistance) == ExplorerStatus::UNTIL_DISTANCE);
static_assert(static_cast<int>(exploration::ExplorerReason::kStartedAgain) == ExplorerStatus::STARTED_AGAIN);
static_assert(static_cast<int>(exploration::ExplorerReason::kUntilShare) == ExplorerStatus::UNTIL_SHARE);
static_assert(static_cast<int>(exploration::ExplorerReason::kUntilBattery) == ExplorerStatus::UNTIL_BATTERY);
static_assert(static_cast<int>(exploration::ExplorerReason::kLeftToOthers) == ExplorerStatus::LEFT_TO_OTHERS);
static_assert(static_cast<int>(exploration::ExplorerReason::kEmergencyStop) == ExplorerStatus::EMERGENCY_STOP);
static_assert(static_cast<int>(exploration::ExplorerReason::kNavigationUnable) == ExplorerStatus::NAVIGATION_UNABLE);

ExplorerStatus toStatusMsg(const exploration::ExplorerProgress& progress, const std::string& frame, Time stamp) {
  ExplorerStatus msg;
  msg.header.frame_id = frame;
  msg.header.stamp = toRosTime(stamp);
  msg.state = static_cast<std::uint8_t>(progress.state);
  msg.state_text = toString(progress.state);
  msg.phase = static_cast<std::uint8_t>(progress.phase);
  msg.phase_text = toString(progress.phase);
  msg.reason = static_cast<std::uint8_t>(progress.reason);
  msg.reason_text = progress.reason_text;
  msg.frontiers_found = progress.frontiers_found;
  msg.frontiers_selectable = progress.frontiers_selectable;
  msg.frontiers_blacklisted = progress.frontiers_blacklisted;
  msg.goals_sent = progress.goals_sent;
  msg.goals_reached = progress.goals_reached;
  msg.goals_failed = progress.goals_failed;
  msg.inspected = progress.inspected;
  msg.inspections_failed = progress.inspections_failed;
  msg.explored_area = progress.explored_area;
  msg.distance_travelled = progress.distance_travelled;
  msg.exploring_time = progress.exploring_time;
  msg.exploring_distance = progress.exploring_distance;
  constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
  msg.estimated_area = progress.whole ? progress.whole->area : kNotKnown;
  msg.estimated_area_deviation = progress.whole ? progress.whole->deviation : kNotKnown;
  msg.share_explored = progress.shareExplored().value_or(kNotKnown);
  msg.time_left = progress.whole ? progress.whole->time_left : kNotKnown;
  return msg;
}

/// Adds what bounds and ends the exploration. [EXP-10]
void FrontierExplorerAdapter::addLimits(ExplorerStatus& msg) const {
  const exploration::ExplorationBounds& bounds = explorer_.bounds();
  msg.stay_within = toPolygonMsg(bounds.stay_within);
  for (const std::vector<Vec2>& area : bounds.keep_out) msg.keep_out.push_back(toPolygonMsg(area));
  msg.clicked_corners = toPolygonMsg(clicked_.corners());
  msg.until = parameters_.explorer.until.inWords(status_.explored_before);
  if (missesBattery()) msg.until += std::string(" (") + kNoBattery + ")";
  msg.battery = battery().value_or(std::numeric_limits<double>::quiet_NaN());
  msg.return_to_start = static_cast<std::uint8_t>(explorer_.returnsToStart());
  msg.save_map_at_end = map_at_end_.path();
  msg.map_saved = map_at_end_.outcome();
}

/// Keeps the charge. One that is not measured (NaN) is no fault of the message.
void FrontierExplorerAdapter::handleBattery(const sensor_msgs::BatteryState& msg) {
  std::string why;
  battery_.clear();
  if (std::isnan(msg.percentage)) return;
  if (const auto charge = toCharge(msg, battery_in_percent_, &why)) {
    battery_.put(*charge, steadyNow());
  } else {
    bad_battery_.add(why);
  }
}

std::optional<double> FrontierExplorerAdapter::battery() const { return battery_.fresh(steadyNow(), kBatteryLifetime); }

/// Whether the exploration is to end by a battery that nobody tells of.
bool FrontierExplorerAdapter::missesBattery() const { return parameters_.explorer.until.battery > 0.0 && !battery(); }

void FrontierExplorerAdapter::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  using Reason = exploration::ExplorerReason;
  const bool asked_to_wait = status_.reason == Reason::kPaused || status_.reason == Reason::kEmergencyStop ||
                             status_.reason == Reason::kOthersGoal;
  const bool waits = status_.state == exploration::ExplorerState::kIdle && !asked_to_wait;
  const bool stuck = status_.reason == Reason::kTooManyFrontiers || status_.reason == Reason::kRobotOutOfBounds;
  status.summary(waits || stuck || map_at_end_.isLost() ? DiagnosticStatus::WARN : DiagnosticStatus::OK,
                 std::string(toString(status_.state)) + ": " + status_.reason_text);
  if (missesBattery()) {
    status.mergeSummary(DiagnosticStatus::WARN, std::string("until/battery is set, but ") + kNoBattery);
  }
  status.add("frontiers", status_.frontiers_found);
  status.add("selectable", status_.frontiers_selectable);
  status.add("goals sent", status_.goals_sent);
  status.add("explored [m2]", status_.explored_area);
  if (status_.whole) {
    status.addf("estimate of the whole [m2]", "%.0f +- %.0f", status_.whole->area, status_.whole->deviation);
    if (std::isfinite(status_.whole->time_left)) status.addf("time left [s]", "%.0f", status_.whole->time_left);
  }
  if (!explorer_.bounds().empty()) status.add("bounds", explorer_.bounds().describe());
  if (!map_at_end_.outcome().empty()) status.add("map at the end", map_at_end_.outcome());
  if (battery()) status.add("battery", *battery());
  map_.rejections().report(status);
  bad_odometry_.report(status);
  bad_clicks_.report(status);
  bad_battery_.report(status);
  bad_inspections_.report(status);
  tf_.report(status);
  navigation_.report(status);
}

}  // namespace frontier_pilot
