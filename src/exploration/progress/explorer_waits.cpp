// What the explorer waits for. [EXP-8]
#include <string>
#include <utility>
#include <vector>

#include "exploration/explorer_impl.h"

namespace frontier_pilot::exploration {
namespace {

/// The missing input by the name that users know.
std::string nameOfMissing(ExplorerReason reason, const ExplorerInputs& inputs) {
  switch (reason) {
    case ExplorerReason::kMapGone:
      return "map";
    case ExplorerReason::kOdometryGone:
      return "odometry";
    case ExplorerReason::kPoseGone:
      return "TF from map to base";
    case ExplorerReason::kNotLocalized:
      return "the robot's place on the map";
    case ExplorerReason::kNavigationDisabled:
      return "the arbiter's permission to drive (" + inputs.navigation_refused + ")";
    default:
      return "move_base";
  }
}

std::string listMissing(const std::vector<ExplorerReason>& missing, const ExplorerInputs& inputs) {
  std::string text;
  for (const ExplorerReason reason : missing) text += (text.empty() ? "" : ", ") + nameOfMissing(reason, inputs);
  return text;
}

bool isOlder(Time stamp, Time now, double age) { return now - stamp > fromSeconds(age); }

}  // namespace

/// Whether the explorer may act: it is enabled and every input is available. [EXP-8]
bool Explorer::Impl::ready(const ExplorerInputs& inputs, Time now) {
  const bool is_told_to_stand = !inputs.enabled || inputs.stopped || inputs.others_goal;
  if (is_told_to_stand) return_waits_since_.reset();
  if (!inputs.enabled) {
    standFor(ExplorerReason::kPaused, now);
    return false;
  }
  if (inputs.stopped) {
    if (status_.state != ExplorerState::kDone) standFor(ExplorerReason::kEmergencyStop, now);
    return false;
  }
  const std::vector<ExplorerReason> missing = missingInputs(inputs, now);
  if (missing.empty()) {
    last_report_.reset();
    return !yield(inputs, now);
  }
  if (status_.state != ExplorerState::kDone) stopFor(listMissing(missing, inputs), missing.front(), now);
  return false;
}

void Explorer::Impl::standFor(ExplorerReason reason, Time now) {
  cancelGoal();
  if (status_.reason == reason) return;
  enter(ExplorerState::kIdle, reason, "", now);
}

/// Whether an input is too old. One that `was_stale` has to be fresh again: where the age of an input varies around the
/// limit, goals would be sent and taken back in turn.
bool Explorer::Impl::isStale(Time stamp, Time now, bool& was_stale) const {
  const double age = was_stale ? 0.5 * parameters_.input_timeout : parameters_.input_timeout;
  was_stale = isOlder(stamp, now, age);
  return was_stale;
}

std::vector<ExplorerReason> Explorer::Impl::missingInputs(const ExplorerInputs& inputs, Time now) {
  std::vector<ExplorerReason> missing;
  if (!inputs.map_available || evaluator_.map().empty()) missing.push_back(ExplorerReason::kMapGone);
  if (!inputs.odometry_stamp || isStale(*inputs.odometry_stamp, now, odometry_is_stale_)) {
    missing.push_back(ExplorerReason::kOdometryGone);
  }
  const std::optional<StampedPose2>& pose = inputs.T_map_base;
  if (!pose || !pose->pose.isFinite() || isStale(pose->stamp, now, pose_is_stale_)) {
    missing.push_back(ExplorerReason::kPoseGone);
  }
  if (!inputs.localized) missing.push_back(ExplorerReason::kNotLocalized);
  if (!inputs.navigation_available) missing.push_back(ExplorerReason::kNavigationGone);
  if (!inputs.navigation_refused.empty()) missing.push_back(ExplorerReason::kNavigationDisabled);
  return missing;
}

void Explorer::Impl::stopFor(const std::string& missing, ExplorerReason first, Time now) {
  const bool gives_up = givesUpReturn(goal_, now);
  cancelGoal();
  if (gives_up) {
    note(true, "the robot does not return to the start: missing " + missing);
    return enter(ExplorerState::kDone, *done_reason_, "", now);
  }
  const ExplorerReason reason = was_running_ ? first : ExplorerReason::kWaitingForInputs;
  const std::string text = "missing: " + missing;
  const bool news = status_.state != ExplorerState::kIdle || status_.reason != reason || status_.reason_text != text;
  if (news) enter(ExplorerState::kIdle, reason, text, now);
  if (!last_report_ || now - *last_report_ >= fromSeconds(parameters_.report_period)) {
    note(true, "exploration waits for: " + missing);
    last_report_ = now;
  }
}

/// Whether the robot returns to the start and has got nowhere for a minute, because an input is missing or the
/// navigation cannot drive. It is to be asked each time that the way back to `goal`, the present one, has to wait. The
/// exploration is done only after the way back, and the map is saved only then. [EXP-10]
bool Explorer::Impl::givesUpReturn(const std::optional<Goal>& goal, Time now) {
  constexpr double kGotOn = 0.1;  // [m]
  constexpr Duration kLongest = std::chrono::minutes(1);
  if (!done_reason_) return false;
  const bool got_on = goal && (T_map_base_->position() - goal->sent_from).norm() >= kGotOn;
  if (!return_waits_since_ || got_on) return_waits_since_ = now;
  return now - *return_waits_since_ >= kLongest;
}

void Explorer::Impl::endReturn() {
  done_reason_.reset();
  return_waits_since_.reset();
}

/// A goal that the navigation gave up for no fault of the goal has not failed: any other would have ended in the same
/// way. Until the robot has driven again it claims nothing, and its attempts are no time of the exploration. [EXP-8]
/// [MUL-2]
void Explorer::Impl::standUntilItCanDrive(const std::string& what, Time now) {
  unable_at_ = T_map_base_->position();
  const std::string text = std::string(toString(ExplorerReason::kNavigationUnable)) + ": " + what;
  note(true, "exploration waits for the navigation: " + what);
  goal_pose_.reset();
  enter(ExplorerState::kIdle, ExplorerReason::kNavigationUnable, text, now);
}

/// Whether it is too soon to send such a goal again. The navigation alone knows what it lacks.
bool Explorer::Impl::waitsForNavigation(Time now) const {
  constexpr Duration kBetweenAttempts = std::chrono::seconds(5);
  return status_.state == ExplorerState::kIdle && status_.reason == ExplorerReason::kNavigationUnable &&
         now - state_since_ < kBetweenAttempts;
}

/// Whatever was chosen on the map of before is a place on that one: the next goal is chosen some seconds later, when
/// the new map has come. [MAP-5] [NAV-1]
void Explorer::Impl::obeyReplacedMap(Time now) {
  if (!std::exchange(map_replaced_, false)) return;
  if (status_.state == ExplorerState::kIdle || status_.state == ExplorerState::kDone) return;
  cancelGoal();
  nothing_left_since_.reset();
  standUntilItCanDrive("the map was replaced", now);
}

}  // namespace frontier_pilot::exploration
