#include "ros/common/inputs/input_watch.h"

#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr Duration kStarting = std::chrono::seconds(2);  // an input that is only starting is not reported
constexpr Duration kAgain = std::chrono::seconds(10);

}  // namespace

void InputWatch::look(const Topics& topics, SteadyTime now) {
  std::string all;
  for (const Missing& missing : needs_) {
    const std::string one = missing(topics);
    if (!one.empty()) all += (all.empty() ? "" : "; ") + one;
  }
  if (!grace_) grace_.emplace(now);
  const bool was_ready = ready();
  looked_ = true;
  missing_ = all;
  if (all.empty()) {
    if (!was_ready) THROTTLED_INFO("ready: all inputs are there");
    since_ = said_ = std::nullopt;
    return;
  }
  if (!since_) since_ = now;
  if (now - *since_ < kStarting || (said_ && now - *said_ < kAgain)) return;
  said_ = now;
  THROTTLED_LOG(grace_->level(now), "waiting: " << all);
}

void InputWatch::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  if (needs_.empty()) return;
  status.add("inputs", ready() ? "all there" : missing_);
  if (said_) status.mergeSummary(diagnostic_msgs::DiagnosticStatus::WARN, "waiting: " + missing_);
}

}  // namespace frontier_pilot
