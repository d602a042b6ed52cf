#include "ros/common/clock_monitor.h"

#include <algorithm>

#include "ros/common/clock.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {

namespace {

constexpr double kMonitorPeriod = 0.05;  // [s]
constexpr Duration kRecentJump = std::chrono::seconds(10);
constexpr Duration kStandstill = std::chrono::seconds(2);   // long enough for one step of a slow simulation
constexpr Duration kLeastAhead = std::chrono::seconds(10);  // the clocks of two machines may differ

}  // namespace

ClockPace clockPace() { return ros::Time::isSimTime() ? kSimulatedPace : kRealPace; }

Duration mostAhead(const ClockPace& pace) { return std::max(kLeastAhead, fromSeconds(pace.slack)); }

bool isAhead(Time stamp, Time now) { return now > Time{} && stamp > now && stamp - now > mostAhead(clockPace()); }

std::string standstill(const Instant& moved, const Instant& now) {
  if (now.ros != moved.ros || now.steady - moved.steady < kStandstill) return {};
  if (now.ros == Time{}) return "no /clock received yet";
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now.steady - moved.steady);
  return "ROS time has stood still for " + std::to_string(seconds.count()) + " s";
}

ClockMonitor::ClockMonitor(const ros::NodeHandle& node) : trust_(clockPace()), moved_{rosNow(), steadyNow()} {
  poll_ = ros::NodeHandle(node).createSteadyTimer(ros::WallDuration(kMonitorPeriod),
                                                  [this](const ros::SteadyTimerEvent&) { look(); });
}

std::optional<Time> ClockMonitor::now() {
  const Time time = look();
  return trust_.trusted() ? std::optional<Time>(time) : std::nullopt;
}

Time ClockMonitor::look() {
  const Instant now{rosNow(), steadyNow()};
  catching_up_ = hold_ups_.isCatchingUp(now.steady);
  if (now.ros != moved_.ros) moved_ = now;
  const TrustChange change = trust_.observe(now);
  if (change == TrustChange::kNone) return now.ros;
  for (const auto& forget : forget_) guard_.run("a jump of the clock", forget);
  if (change == TrustChange::kLost) {
    THROTTLED_WARN("the clock jumped by " << trust_.jump() << " s: waiting until it runs steadily");
  } else {
    THROTTLED_WARN("the clock runs steadily again (jumps so far: " << trust_.jumps() << ")");
  }
  return now.ros;
}

void ClockMonitor::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  status.add("jumps of the clock", trust_.jumps());
  status.add("times that this process was held up", hold_ups_.count());
  guard_.report(status);
  const std::string still = standstill(moved_, {rosNow(), steadyNow()});
  if (!still.empty()) status.mergeSummary(DiagnosticStatus::WARN, still);
  if (trust_.jumps() == 0 || steadyNow() - trust_.lastJumped() > kRecentJump) return;
  status.mergeSummaryf(DiagnosticStatus::WARN, "the clock jumped by %+.3f s", trust_.jump());
}

}  // namespace frontier_pilot
