#include <iomanip>

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/tf/frame_name.h"
#include "ros/common/throttled_log.h"
#include "ros/mapper/mapper_adapter.h"

namespace frontier_pilot {
namespace {

/// A scan that is older than this [s] was not delayed: its stamp is of another clock.
constexpr double kNoDelay = 60.0;

/// What may be wrong where a scan is refused as stale; empty if it may have been delayed.
std::string causeOf(mapping::ScanVerdict verdict, Time stamp) {
  if (verdict != mapping::ScanVerdict::kStale || toSeconds(rosNow() - stamp) < kNoDelay) return {};
  return std::string("by more than a minute: its stamp is of another clock than this node's, which is ") +
         (ros::Time::isSimTime() ? "/clock" : "the computer's (use_sim_time is false)");
}

}  // namespace

void MapperAdapter::handleOdometry(const nav_msgs::Odometry& msg) {
  if (!isSameFrame(msg.header.frame_id, odom_frame_)) {
    return bad_odometry_.add("frame '" + msg.header.frame_id + "' is not '" + odom_frame_ + "'");
  }
  std::string why;
  const auto odometry = toOdometry(msg, &why);
  if (!odometry) return bad_odometry_.add(why);
  const auto now = connections_.clock().now();
  if (!now) return bad_odometry_.add("the clock jumped");
  if (isAhead(odometry->stamp, *now)) return bad_odometry_.add("stamp too far in the future");
  resume(odometry->T_odom_base);
  const std::uint64_t resets = anchor_.resets();
  if (!pairing_.addOdometry(odometry->stamp, odometry->T_odom_base, anchor_))
    return bad_odometry_.add(mapping::OdometryAnchor::kWithheld);
  if (anchor_.resets() != resets) noteOdometryReset();
  insertPaired();
}

void MapperAdapter::insertPaired() {
  // The clock is read for each scan: those that become stale while others are processed are dropped.
  while (const auto paired = pairing_.next(rosNow())) {
    if (scan_motion_.note(timing_, paired->covered, paired->scan, paired->T_odom_base)) {
      publishIfLost();  // this scan may already find it
      const mapping::ScanVerdict verdict = mapper_.insert(paired->scan, paired->T_odom_base, rosNow());
      note(verdict, causeOf(verdict, paired->scan.stamp));
      if (!paired->T_odom_base) continue;
      const Pose2 T_map_base = mapper_.T_map_odom() * *paired->T_odom_base;
      if (verdict == mapping::ScanVerdict::kInserted) saver_.way().note(T_map_base.position());
      sayWhereLocalised(verdict, T_map_base);
    } else {
      bad_scans_.add(kFrozenScan);
    }
  }
}

void MapperAdapter::noteOdometryReset() {
  odometry_reset_ = steadyNow();
  const mapping::OdometryAnchor::Jump& jump = anchor_.lastJump();
  THROTTLED_WARN("odometry jumped by " << std::fixed << std::setprecision(2) << jump.distance << " m and "
                                       << jump.turn * 180.0 / kPi << " deg within " << jump.seconds
                                       << (parameters_.mapper.trust_odometry
                                               ? " s: odometry is trusted, so the robot jumps in the map as well"
                                               : " s: taken for a reset, the robot stays where it is in the map"));
  rememberPose();
  broadcast();
}

void MapperAdapter::publishIfLost() {
  if (restored_ || !mapper_.isLocalized()) publisher_.publishLost();
}

void MapperAdapter::broadcast() {
  publishIfLost();
  // Where odometry is in the map that is kept is not known before it comes: it may have been reset as well. [FLT-2]
  // The robot's place in a map that others do not use is no place in the one that they use. [MAP-3]
  if (restored_ || !publisher_.owns()) return;
  const auto now = connections_.clock().now();
  if (!now) return;  // after a jump of the clock the stamp might lie far in the future
  const Time stamp = *now + fromSeconds(parameters_.tf_lead);
  tf_.broadcast(parameters_.map_frame, odom_frame_, T_map_odom(), stamp);
  if (mapper_.isLocalized()) publisher_.publishLocalized(fromSeconds(parameters_.tf_lead + parameters_.tf_period));
}

void MapperAdapter::reportOdometry(Status& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  constexpr Duration kNews = std::chrono::seconds(10);
  const SteadyTime now = steadyNow();
  const mapping::OdometryAnchor::Jump& jump = anchor_.lastJump();
  status.add("odometry resets", anchor_.resets());
  status.addf("last reset of odometry [m, deg]", "%.2f, %.1f", jump.distance, jump.turn * 180.0 / kPi);
  const Pose2 T_map_odom = this->T_map_odom();
  status.addf("map -> odom [m, m, deg]", "%.3f, %.3f, %.2f", T_map_odom.x, T_map_odom.y, T_map_odom.yaw * 180.0 / kPi);
  if (odometry_reset_ && now - *odometry_reset_ < kNews) {
    status.mergeSummary(DiagnosticStatus::WARN, "odometry jumped, taken for a reset");
  }
}

}  // namespace frontier_pilot
