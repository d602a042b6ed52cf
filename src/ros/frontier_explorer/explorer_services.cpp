#include <utility>

#include "ros/common/master/registration.h"
#include "ros/common/throttled_log.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"

/// What the explorer serves, with its switches and how they outlive it, an emergency stop among them, and its tunable
/// parameters. The handlers of the bounds are in explorer_bounds.cpp, that of the poses to be inspected is in
/// explorer_inspections.cpp.
namespace frontier_pilot {

void FrontierExplorerAdapter::addServices() {
  connections_.serve(names::kSetExplorationEnabled, &FrontierExplorerAdapter::handleEnable, this);
  connections_.serve(names::kSetReturnToStart, &FrontierExplorerAdapter::handleReturnToStart, this);
  connections_.serve(names::kResetExplorer, &FrontierExplorerAdapter::handleReset, this);
  connections_.serve(names::kExplainExplorer, &FrontierExplorerAdapter::handleExplain, this);
  connections_.serve(names::kSetExplorationBounds, &FrontierExplorerAdapter::handleSetBounds, this);
  connections_.serve(names::kClearExplorationBounds, &FrontierExplorerAdapter::handleClearBounds, this);
  connections_.serve(names::kClearInspections, &FrontierExplorerAdapter::handleClearInspections, this);
  tuning_.emplace(parameters_, connections_,
                  [this](const ExplorerNodeParameters& changed) { explorer_.setParameters(changed.explorer); });
}

/// Goes on as the process before this one was left, if that has died.
void FrontierExplorerAdapter::resume() {
  paused_.emplace("exploration_paused", names::kSetExplorationEnabled, connections_);
  if (const auto paused = paused_->wasLeftSafe()) enabled_ = !*paused;
  memory_.emplace(connections_);
  const ExplorerOrders& left = memory_->orders();
  if (left.returns_to_start) explorer_.setReturnToStart(*left.returns_to_start);
  if (left.start) explorer_.setStart(*left.start);
  if (left.bounds) {
    explorer_.setBounds(*left.bounds, OccupancyGrid());
    ROS_WARN_STREAM("starts with the bounds that were set before: " << left.bounds->describe());
  }
  if (const std::string why = memory_->whyStand(); !why.empty()) {
    enabled_ = false;
    ROS_WARN_STREAM("starts paused: " << why);
  }
  // The first one of a launch goes on without an arbiter, which another system may not have.
  if (enabled_)
    earlier_stops_.ask(left.stops.value_or(0), left.stops ? Duration::max() : Duration::zero(), steadyNow());
  connections_.inputs().need([this](const auto&) {
    return awaitsArbiter() ? std::string("no arbiter says whether the robot was stopped since the last explorer died")
                           : std::string();
  });
}

/// An exploration that is paused after its end has ended still.
void FrontierExplorerAdapter::remember() {
  memory_->keepStart(explorer_.start());
  if (const auto rule = explorer_.endedBy()) {
    memory_->keepEnd(toString(*rule));
  } else if (enabled_) {
    memory_->keepEnd(std::nullopt);
  }
  if (!enabled_ || earlier_stops_.asks() || !arbiter_.has()) return;
  const bool stopped = stopped_ || arbiter_.get()->emergency_stop != 0;
  memory_->keepStops(stopped ? ExplorerOrders::kStopped : arbiter_.get()->stops);
}

void FrontierExplorerAdapter::sayLastWords() {
  navigation_.cancel();
  paused_->end();
  if (!nameIsTaken()) return memory_->end();
  ROS_WARN("another process has this node's name: the orders are left for the explorer that is started after it");
  memory_->leave();
}

bool FrontierExplorerAdapter::handleEnable(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  const bool before = enabled_;
  enabled_ = start_ = request.data != 0;
  // Whoever calls knows whether the robot was stopped, but not whether this explorer would hear of the clear.
  const auto& known = memory_->orders().stops;
  earlier_stops_.dismiss();
  if (enabled_ && !earlier_stops_.hears() && known) earlier_stops_.ask(*known, Duration::max(), steadyNow());
  const std::string problem = paused_->set(!enabled_);
  const exploration::ExplorerState state_before = status_.state;
  tick();  // so that a pause cancels the goal before the call is answered
  response.success = 1U;
  response.message =
      std::string(enabled_ ? "exploration enabled" : "exploration paused") +
      (before == enabled_ && status_.state == state_before && !waits() ? " already: nothing changed" : "") +
      (enabled_ && stopped_ ? "; the robot is stopped, and clearing the stop pauses it" : "") +
      (awaitsArbiter() ? "; it waits until the arbiter says whether the robot was stopped meanwhile" : "") +
      (enabled_ ? afterItsEnd() : "") + problem + fromWhen();
  return true;
}

/// What to do about an exploration that has ended: to enable it goes on with one that a stopping rule has ended, but
/// not where nothing is left.
std::string FrontierExplorerAdapter::afterItsEnd() {
  if (status_.state != exploration::ExplorerState::kDone || waits()) return {};
  return std::string("; it has ended (") + toString(status_.reason) + "): " +
         (explorer_.endedBy() ? std::string(names::kSetExplorationEnabled) + " true goes on"
                              : std::string(names::kResetExplorer) + " begins it anew") +
         ", and at the end of that the robot " +
         (explorer_.returnsToStart() ? "returns to its start" : "stays where it is");
}

/// A stop cancels the goal at once: the next tick may come only after the clear. After that the exploration does not go
/// on by itself. [ARB-8]
void FrontierExplorerAdapter::handleStop(const std_msgs::Bool& msg) {
  earlier_stops_.hear();
  const bool was_stopped = std::exchange(stopped_, msg.data != 0);
  if (stopped_) {
    order_ = {};
    navigation_.cancel();
  }
  if (was_stopped && !stopped_) pause("the emergency stop was cleared");
}

/// Whoever begins, or goes on after a death, has not seen what happened before. [ARB-8] [FLT-2]
void FrontierExplorerAdapter::handleArbiter(const ArbiterStatus& msg) {
  arbiter_.put(msg, steadyNow());
  permission_.take(msg, rosNow(), steadyNow());
  if (earlier_stops_.take(msg.stops).value_or(false))
    pause("an emergency stop was called while no explorer was there to be paused by its clear");
}

void FrontierExplorerAdapter::pause(const std::string& why) {
  if (!enabled_) return;
  enabled_ = false;
  earlier_stops_.dismiss();
  paused_->set(true);
  THROTTLED_WARN("exploration paused because " << why << ": call set_exploration_enabled true to go on");
  tick();
}

bool FrontierExplorerAdapter::handleReturnToStart(std_srvs::SetBool::Request& request,
                                                  std_srvs::SetBool::Response& response) {
  const bool before = explorer_.returnsToStart();
  explorer_.setReturnToStart(request.data != 0);
  const std::string problem = memory_->keepReturnToStart(request.data != 0);
  last_status_.reset();
  tick();  // so that the status is as the answer says
  response.success = 1U;
  response.message =
      std::string(explorer_.returnsToStart() ? "returns to the start at the end" : "stays where the exploration ends") +
      (before == explorer_.returnsToStart() ? " already: nothing changed" : "") + afterItsEnd() + problem;
  return true;
}

bool FrontierExplorerAdapter::handleReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  reset_ = true;
  tick();
  response.success = 1U;
  response.message = "blacklist, visits and phase forgotten" + fromWhen();
  return true;
}

bool FrontierExplorerAdapter::handleExplain(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  response.success = 1U;
  response.message = explorer_.explain();
  return true;
}

}  // namespace frontier_pilot
