#include "ros/mapper/mapper_adapter.h"

#include <iomanip>

#include "ros/common/clock.h"
#include "ros/common/clock_monitor.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/parameters.h"
#include "ros/common/tf/frame_name.h"
#include "ros/common/tf/odometry_source.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

mapping::OdometryAnchorParameters anchorParameters(const MapperNodeParameters& node) {
  mapping::OdometryAnchorParameters parameters = node.odometry;
  parameters.trusted = node.mapper.trust_odometry;
  return parameters;
}

}  // namespace

MapperAdapter::MapperAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : parameters_(loadNodeParameters<MapperNodeParameters>(private_node)),
      base_frame_(parameters_.mapper.robot.baseFrameOr(parameters_.base_frame)),
      odom_frame_(parameters_.mapper.robot.odomFrameOr(parameters_.odom_frame)),
      mapper_(parameters_.mapper),
      anchor_(anchorParameters(parameters_)),
      pairing_(parameters_.pairing),
      publisher_(node, parameters_.map_frame, parameters_.publishing),
      diagnostics_(node, private_node),
      connections_(node) {
  loadFirstMap(private_node);
  diagnostics_.add("mapping", [this](Status& status) { report(status); });
  diagnostics_.add("connections", [this](Status& status) { connections_.report(status); });
  diagnostics_.add("memory", [this](Status& status) {
    autosave_.tell(connections_.memory());
    connections_.memory().report(status);
  });
  advertiseServices();
  connect();
}

void MapperAdapter::connect() {
  connections_.master().claimTopics({publisher_.topic()});
  followOdometry(connections_, tf_, parameters_.mapper.robot, base_frame_, 100, &MapperAdapter::handleOdometry, this);
  connections_.subscribeToCommands(names::kInitialPose, 1, &MapperAdapter::handleInitialPose, this);
  connections_.subscribeToScanner(tf_, base_frame_, 20, &MapperAdapter::handleScan, this);
  connections_.every(ros::Duration(parameters_.update_period), [this] {
    const auto now = connections_.clock().now();
    if (!now) return;
    publishIfLost();  // before a map on which the robot is looked for
    insertPaired();
    startRevision();
    if (!restored_) publisher_.publish(mapper_, *now);
  });
  connections_.every(ros::Duration(parameters_.tf_period), [this] { broadcast(); });
  connections_.clock().onJump([this] {
    pairing_.clear();
    anchor_.forgetTime();
  });
  connections_.master().onSession([this](const auto& sessions) { session_.put(sessions); });
  if (parameters_.autosave_period > 0.0) {
    connections_.everySteady(ros::WallDuration(parameters_.autosave_period), [this] { autosave(); });
  }
  connections_.everySteady(ros::WallDuration(0.1), [this] {
    saver_.provide(restored_ ? restored_->map : mapper_.map());
    searcher_.provide(mapper_);
    const auto report = connections_.master().take();
    if (!report) return;
    const auto other = report->rivals.find(publisher_.topic());
    publisher_.setOther(other == report->rivals.end() ? "" : other->second);
  });
}

void MapperAdapter::handleScan(const sensor_msgs::LaserScan& msg) {
  if (!connections_.clock().now()) return bad_scans_.add("the clock jumped");
  if (auto scan = read(msg)) pairing_.addScan(std::move(*scan));
  insertPaired();
}

/// Converts the scan; nothing if it is unusable, which is counted.
std::optional<LaserScan2> MapperAdapter::read(const sensor_msgs::LaserScan& msg) {
  const std::string& frame = msg.header.frame_id;
  std::string why;
  const auto reject = [&](mapping::ScanVerdict verdict) {
    mapper_.reject(verdict, rosNow());
    note(verdict, why);
    return std::nullopt;
  };
  why = "frame '" + frame + "'";
  // TF would also give a pose for a scan in the map or odom frame, but a scanner has to be fixed to the robot.
  if (frame.empty() || isSameFrame(frame, parameters_.map_frame) || isSameFrame(frame, odom_frame_)) {
    return reject(mapping::ScanVerdict::kWrongFrame);
  }
  const auto T_base_sensor = tf_.lookup3d(base_frame_, frame, Time{}, Duration::zero(), &why);
  if (!T_base_sensor) return reject(mapping::ScanVerdict::kNoTransform);
  auto scan = toLaserScan(msg, *T_base_sensor, &why);
  if (!scan) return reject(mapping::ScanVerdict::kMalformed);
  timing_.apply(*scan);
  return scan;
}

void MapperAdapter::startRevision() {
  if (auto done = worker_.take()) takeOver(*done);
  if (const auto failure = worker_.takeFailure(); failure && mapper_.abandonWork()) {
    revision_failure_ = *failure;
    ROS_ERROR_STREAM("loop closing is off until a reset, the map is kept: " << *failure);
  }
  if (!worker_.idle()) return;
  slam::RevisionWork work = mapper_.takeWork();
  if (!work) return;
  // Freeing a replaced map takes a while, so the worker does that, too.
  worker_.start([work = std::move(work), old = std::exchange(old_, nullptr)]() mutable {
    old.reset();
    const SteadyTime start = steadyNow();
    slam::MapRevision revision = work();
    return TimedRevision{std::move(revision), toSeconds(steadyNow() - start)};
  });
}

void MapperAdapter::takeOver(TimedRevision& done) {
  if (!mapper_.revise(done.revision)) return;
  revision_seconds_ = done.seconds;
  const slam::MapRevision& revision = done.revision;
  if (!revision.closures.empty()) {
    THROTTLED_INFO("loop closed: " << revision.closures.size() << " closures, the robot moved by " << std::fixed
                                   << std::setprecision(3) << revision.T_new_old.position().norm() << " m and "
                                   << std::setprecision(2) << revision.T_new_old.yaw * 180.0 / kPi
                                   << " deg in the map");
    broadcast();
  }
  if (revision.map) old_ = std::make_shared<slam::MapRevision>(std::move(done.revision));
}

void MapperAdapter::note(mapping::ScanVerdict verdict, const std::string& detail) {
  if (!mapping::isDropped(verdict)) {
    last_inserted_ = steadyNow();
    return;
  }
  const std::string why = detail.empty() ? toString(verdict) : std::string(toString(verdict)) + ", " + detail;
  using mapping::ScanVerdict;
  const bool waits = verdict == ScanVerdict::kNoTransform || verdict == ScanVerdict::kNoOdometry;
  if (waits) return bad_scans_.addWaiting(why);
  bad_scans_.add(why);
}

}  // namespace frontier_pilot
