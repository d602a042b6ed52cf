#include "teleop/operator_events.h"

#include <algorithm>

namespace frontier_pilot::teleop {
namespace {

using Lines = std::vector<OperatorLogLine>;

/// The view, or nullptr if there is none or its status is too old to count.
template <class View>
const View* heard(const std::optional<View>& view) {
  return view && view->status_age <= kStatusLifetime ? &*view : nullptr;
}

void noteStop(const OperatorState& before, const OperatorState& now, Lines& lines) {
  const bool was = before.emergency_stop.value_or(false), is = now.emergency_stop.value_or(false);
  if (was && !is && now.emergency_stop) lines.push_back({Severity::kGood, "emergency stop cleared"});
  if (was || !is) return;
  const std::string cause = now.arbiter ? now.arbiter->stop_cause : "";
  lines.push_back({Severity::kError, "emergency stop" + (cause.empty() ? "" : ": " + cause)});
}

void noteContact(const OperatorState& before, const OperatorState& now, Lines& lines) {
  if (!before.contact.value_or(false) && now.contact.value_or(false)) {
    const bool known = heard(now.arbiter) != nullptr && !now.arbiter->active_source.empty();
    lines.push_back({Severity::kError, "the robot touches something" +
                                           (known ? " while " + now.arbiter->active_source + " drives" : "")});
  }
}

void noteArbiter(const OperatorState& before, const OperatorState& now, Lines& lines) {
  const ArbiterView* was = heard(before.arbiter);
  const ArbiterView* is = heard(now.arbiter);
  if (was != nullptr && is == nullptr) lines.push_back({Severity::kError, "the arbiter fell silent"});
  if (is == nullptr) return;
  if (was != nullptr && was->active_source != is->active_source) {
    lines.push_back({Severity::kIdle, is->driver()});
  }
  for (const std::string& problem : is->problems) {
    const bool known = was != nullptr && std::count(was->problems.begin(), was->problems.end(), problem) > 0;
    // A stop has already been reported with its cause.
    const bool stop = !is->stop_cause.empty() && problem.find(is->stop_cause) != std::string::npos;
    if (!known && !stop) lines.push_back({Severity::kWarning, problem});
  }
}

void noteAvoider(const OperatorState& before, const OperatorState& now, Lines& lines) {
  const AvoiderView* was = heard(before.avoider);
  const AvoiderView* is = heard(now.avoider);
  if (is == nullptr || is->severity != Severity::kError) return;
  if (was == nullptr || was->severity != Severity::kError) {
    lines.push_back({Severity::kError, "avoider: " + is->state_text});
  }
}

void noteExplorer(const OperatorState& before, const OperatorState& now, Lines& lines) {
  const ExplorerView* was = heard(before.explorer);
  const ExplorerView* is = heard(now.explorer);
  if (was != nullptr && is == nullptr) lines.push_back({Severity::kError, "the explorer fell silent"});
  if (is == nullptr) return;
  const bool same = was != nullptr && was->state_text == is->state_text && was->reason_text == is->reason_text;
  // The explorer usually starts paused (kIdle), which is not worth a line.
  if (same || (was == nullptr && is->severity == Severity::kIdle)) return;
  const Severity severity = is->severity == Severity::kActive ? Severity::kIdle : is->severity;
  lines.push_back({severity, "explorer: " + is->state_text + ", " + is->reason_text});
}

void notePatrol(const OperatorState& before, const OperatorState& now, Lines& lines) {
  const std::string& leg = now.patrol.feedback;
  if (!leg.empty() && leg != before.patrol.feedback) lines.push_back({Severity::kIdle, "patrol: " + leg});
}

}  // namespace

std::vector<OperatorLogLine> eventsBetween(const OperatorState& before, const OperatorState& now) {
  Lines lines;
  noteStop(before, now, lines);
  noteContact(before, now, lines);
  noteArbiter(before, now, lines);
  noteAvoider(before, now, lines);
  noteExplorer(before, now, lines);
  notePatrol(before, now, lines);
  return lines;
}

}  // namespace frontier_pilot::teleop
