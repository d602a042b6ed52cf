#include "ros/common/clock.h"
#include "ros/common/throttled_log.h"
#include "ros/frontier_explorer/frontier_explorer_adapter.h"

namespace frontier_pilot {

void FrontierExplorerAdapter::report(const exploration::ExplorerOutput& output) const {
  for (const exploration::ExplorerProgress& to : output.transitions) {
    THROTTLED_INFO(toString(to.state) << " (" << toString(to.phase) << "): " << to.reason_text);
  }
  const bool starts = output.status.reason == exploration::ExplorerReason::kWaitingForInputs;
  for (const exploration::ExplorerNote& note : output.notes) {
    if (!note.warning) {
      THROTTLED_INFO(note.text);
    } else {
      THROTTLED_LOG(starts ? grace_.level(steadyNow()) : ros::console::levels::Warn, note.text);
    }
  }
}

/// Says so while ROS time stands still: ticks are on ROS time, so no tick could report it.
void FrontierExplorerAdapter::watchClock() {
  const Time now = rosNow();
  if (now == watched_clock_) {
    THROTTLED_LOG(grace_.level(steadyNow()), "exploration waits for: /clock (ROS time stands still)");
  }
  watched_clock_ = now;
}

}  // namespace frontier_pilot
