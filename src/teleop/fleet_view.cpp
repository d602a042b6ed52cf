#include "teleop/fleet_view.h"

#include <cmath>
#include <utility>

namespace frontier_pilot::teleop {
namespace {

struct Words {
  Severity severity;
  std::string text;
};

bool isFresh(double age) { return age <= kStatusLifetime; }

/// How much of the whole is estimated to be explored, as the end of a phrase.
std::string shareOf(const ExplorerView& explorer) {
  if (!explorer.share_explored) return {};
  return ", " + std::to_string(std::lround(100.0 * *explorer.share_explored)) + " % seen";
}

/// What a robot does that has nothing to complain of.
Words activityOf(const ArbiterView& arbiter, const RobotReports& reports) {
  const ExplorerView* explorer =
      reports.explorer && isFresh(reports.explorer->status_age) ? &*reports.explorer : nullptr;
  const bool has_goal = reports.navigation && reports.navigation->has_goal;
  const NavigationView* navigation =
      has_goal && isFresh(reports.navigation->status_age) ? &*reports.navigation : nullptr;
  const bool explores = explorer != nullptr && explorer->running;
  if (navigation != nullptr && navigation->severity == Severity::kWarning)
    return {Severity::kWarning, navigation->status + (explores ? shareOf(*explorer) : "")};
  if (explores) return {explorer->severity, "explores" + shareOf(*explorer) + ": " + explorer->reason_text};
  if (navigation != nullptr) return {Severity::kActive, "drives to its goal: " + navigation->status};
  if (!arbiter.active_source.empty() && !arbiter.command.isZero()) return {Severity::kActive, arbiter.driver()};
  if (explorer != nullptr) return {explorer->severity, "stands: " + explorer->reason_text};
  return {Severity::kIdle, "stands"};
}

Words wordsOf(const RobotReports& reports, bool reached) {
  if (!reports.arbiter) return {reached ? Severity::kIdle : Severity::kError, "nothing heard yet"};
  const ArbiterView& arbiter = *reports.arbiter;
  if (!isFresh(arbiter.status_age))
    return {Severity::kError, "silent for " + std::to_string(std::lround(arbiter.status_age)) + " s"};
  if (!arbiter.stop_cause.empty()) return {Severity::kError, "emergency stop: " + arbiter.stop_cause};
  if (arbiter.severity == Severity::kError) return {Severity::kError, arbiter.summary};
  if (!reached) return {Severity::kError, "a stop of all robots does not reach it"};
  if (!arbiter.problems.empty()) return {Severity::kWarning, arbiter.problems.front()};
  return activityOf(arbiter, reports);
}

}  // namespace

RobotView atAGlance(const std::string& name, const RobotReports& reports, bool reached) {
  Words words = wordsOf(reports, reached);
  return {name, words.severity, std::move(words.text)};
}

}  // namespace frontier_pilot::teleop
