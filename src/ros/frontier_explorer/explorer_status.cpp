#include "ros/frontier_explorer/explorer_status.h"
#include "ros/common/clock.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"

namespace frontier_pilot {

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
  msg.explored_area = progress.explored_area;
  msg.distance_travelled = progress.distance_travelled;
  return msg;
}

void FrontierExplorerAdapter::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  const bool waits =
      status_.state == exploration::ExplorerState::kIdle && status_.reason != exploration::ExplorerReason::kPaused;
  const bool gave_up = status_.reason == exploration::ExplorerReason::kTooManyFrontiers;
  status.summary(waits || gave_up ? DiagnosticStatus::WARN : DiagnosticStatus::OK,
                 std::string(toString(status_.state)) + ": " + status_.reason_text);
  status.add("frontiers", status_.frontiers_found);
  status.add("selectable", status_.frontiers_selectable);
  status.add("goals sent", status_.goals_sent);
  status.add("explored [m2]", status_.explored_area);
  map_.rejections().report(status);
  bad_odometry_.report(status);
  tf_.report(status);
  navigation_.report(status);
}

}  // namespace frontier_pilot
