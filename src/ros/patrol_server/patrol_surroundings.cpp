#include "ros/patrol_server/patrol_surroundings.h"

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/messages/message_problems.h"

namespace frontier_pilot {
namespace {

constexpr Duration kConnecting = std::chrono::seconds(1);  ///< to those who publish a scan, at the start

}  // namespace

PatrolSurroundings::PatrolSurroundings(const PatrolSurroundingsParameters& parameters, const RobotModel& robot,
                                       const TfBridge& tf)
    : parameters_(parameters),
      base_frame_(robot.base_frame),
      tf_(tf),
      check_(parameters.check, robot),
      placer_(robot.scanner) {}

void PatrolSurroundings::subscribe(NodeConnections& connections) {
  if (!parameters_.check_collisions) return;
  connections_ = &connections;
  scan_ = connections.subscribeToScanner(tf_, base_frame_, 1, &PatrolSurroundings::handleScan, this,
                                         ros::TransportHints().tcpNoDelay());
  subscribed_ = steadyNow();
}

void PatrolSurroundings::handleScan(const sensor_msgs::LaserScan& msg) {
  heard_ = true;
  std::string why;
  // The latest transform, not the one at the scan's stamp: the mount does not move, but its publisher may be late.
  const auto T_base_sensor = tf_.lookup3d(base_frame_, msg.header.frame_id, Time{}, Duration::zero(), &why);
  if (!T_base_sensor) return rejections_.addWaiting(why);
  auto scan = toLaserScan(msg, *T_base_sensor, &why);
  if (!scan) return rejections_.add(why);
  if (!scan_motion_.place(placer_, *scan)) return rejections_.add(kFrozenScan);
  const auto T_odom_base = placer_.track().nearest(scan->stamp);
  if (T_odom_base && !check_.insert(*scan, *T_odom_base)) rejections_.add(kDoesNotShowAhead);
}

void PatrolSurroundings::addOdometry(Time stamp, const Pose2& T_odom_base) {
  constexpr double kJump = 0.5;       // [m]
  constexpr double kAngleJump = 1.5;  // [rad]
  const auto& poses = placer_.track().poses();
  if (!poses.empty() && isJump(poses.back().pose, T_odom_base, kJump, kAngleJump)) check_.clear();
  placer_.addOdometry(stamp, T_odom_base);
}

void PatrolSurroundings::lookAheadFor(const patrol::PatrolParameters& parameters) {
  check_.setReach(patrol::reach(parameters, parameters_.costmap_timeout));
}

bool PatrolSurroundings::isConnecting() const {
  if (!parameters_.check_collisions || heard_) return false;
  return steadyNow() - subscribed_ < kConnecting || !connections_->master().hasLooked();
}

/// A node that hangs, or that answers late, publishes a scan although this one is not connected to it.
bool PatrolSurroundings::isPublished() const {
  return scan_.getNumPublishers() > 0 || !connections_->master().publishersOf(scan_.getTopic()).empty();
}

bool PatrolSurroundings::isBlind() const {
  return parameters_.check_collisions && !heard_ && !isConnecting() && !isPublished();
}

patrol::WayAhead PatrolSurroundings::wayAhead(Time now) const {
  if (!parameters_.check_collisions || isBlind()) return {};
  return [this, now](const Pose2& T_odom_base, const Twist2& arc) -> std::optional<std::string> {
    const behavior::LookAhead ahead = check_.lookAhead(parameters_.costmap_timeout, now);
    const auto seen = ahead ? behavior::lookAlongArc(ahead, T_odom_base, arc) : behavior::SweepResult::kNoCostmap;
    // Many drivers report nothing where nothing is in range: the floor there was never seen.
    if (seen == behavior::SweepResult::kClear || seen == behavior::SweepResult::kUnseen) return std::nullopt;
    return std::string("not free ahead: ") + toString(seen);
  };
}

void PatrolSurroundings::clear() {
  placer_.clear();
  check_.clear();
}

void PatrolSurroundings::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  if (!parameters_.check_collisions) return status.add("looks at the scan", "no: check_collisions is off");
  status.add("looks at the scan", isBlind() ? "no: nobody publishes it" : "yes");
  scan_motion_.report(status);
  rejections_.report(status);
}

}  // namespace frontier_pilot
