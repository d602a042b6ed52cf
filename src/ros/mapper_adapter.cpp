#include "frontier_pilot/ros/mapper_adapter.h"

#include <iomanip>

#include "frontier_pilot/ros/clock.h"
#include "frontier_pilot/ros/conversions.h"
#include "frontier_pilot/ros/parameters.h"
#include "frontier_pilot/ros/throttled_log.h"

namespace frontier_pilot {

MapperAdapter::MapperAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : parameters_(loadNodeParameters<MapperNodeParameters>(private_node)),
      mapper_(parameters_.mapper),
      pairing_(parameters_.pairing),
      publisher_(node, parameters_.map_frame, parameters_.publishing),
      watch_({publisher_.topic()}, std::chrono::seconds(2)),
      diagnostics_(node, private_node) {
  loadFirstMap(private_node);
  diagnostics_.add("mapping", [this](Status& status) { report(status); });
  advertiseServices(node);
  odometry_subscriber_ = node.subscribe(names::kOdom, 100, &MapperAdapter::handleOdometry, this);
  initial_pose_subscriber_ = node.subscribe(names::kInitialPose, 1, &MapperAdapter::handleInitialPose, this);
  scan_subscriber_ = node.subscribe(names::kScan, 20, &MapperAdapter::handleScan, this);
  update_timer_ = node.createTimer(ros::Duration(parameters_.update_period), [this](const ros::TimerEvent&) {
    insertPaired();
    think();
    publisher_.publish(mapper_, rosNow());
  });
  tf_timer_ = node.createTimer(ros::Duration(parameters_.tf_period), [this](const ros::TimerEvent&) { broadcast(); });
  watch_timer_ = node.createSteadyTimer(ros::WallDuration(0.1), [this](const ros::SteadyTimerEvent&) {
    if (const auto found = watch_.take()) publisher_.setPublishers(found->at(publisher_.topic()));
  });
}

void MapperAdapter::handleOdometry(const nav_msgs::Odometry& msg) {
  if (msg.header.frame_id != parameters_.odom_frame) {
    return bad_odometry_.add("frame '" + msg.header.frame_id + "' is not '" + parameters_.odom_frame + "'");
  }
  std::string why;
  const auto odometry = toOdometry(msg, &why);
  if (!odometry) return bad_odometry_.add(why);
  pairing_.addOdometry(odometry->stamp, odometry->T_odom_base);
  insertPaired();
}

void MapperAdapter::handleScan(const sensor_msgs::LaserScan& msg) {
  if (auto scan = read(msg)) pairing_.addScan(std::move(*scan));
  insertPaired();
}

std::optional<LaserScan2> MapperAdapter::read(const sensor_msgs::LaserScan& msg) {
  const std::string& frame = msg.header.frame_id;
  std::string why;
  const auto reject = [&](ScanVerdict verdict) {
    mapper_.reject(verdict, rosNow());
    note(verdict, why);
    return std::nullopt;
  };
  why = "frame '" + frame + "'";
  // A scanner that is fixed to the world instead of the robot would be found in TF all the same.
  if (frame.empty() || frame == parameters_.map_frame || frame == parameters_.odom_frame) {
    return reject(ScanVerdict::kWrongFrame);
  }
  const auto T_base_sensor = tf_.lookup3d(parameters_.base_frame, frame, Time{}, Duration::zero(), &why);
  if (!T_base_sensor) return reject(ScanVerdict::kNoTransform);
  auto scan = toLaserScan(msg, *T_base_sensor, &why);
  if (!scan) return reject(ScanVerdict::kMalformed);
  return scan;
}

void MapperAdapter::insertPaired() {
  const Time now = rosNow();
  while (const auto paired = pairing_.next(now)) note(mapper_.insert(paired->scan, paired->T_odom_base, now), {});
}

void MapperAdapter::think() {
  if (auto done = worker_.take()) takeOver(*done);
  if (!worker_.idle()) return;
  RevisionWork work = mapper_.takeWork();
  if (!work) return;
  // A map that has been replaced takes a while to be freed: the worker does that, too.
  worker_.start([work = std::move(work), old = std::exchange(old_, nullptr)] {
    const SteadyTime start = steadyNow();
    Thoughts thoughts{work(), 0.0};
    thoughts.seconds = toSeconds(steadyNow() - start);
    return thoughts;
  });
}

void MapperAdapter::takeOver(Thoughts& thoughts) {
  if (!mapper_.revise(thoughts.revision)) return;
  revision_seconds_ = thoughts.seconds;
  const MapRevision& revision = thoughts.revision;
  if (!revision.closures.empty()) {
    THROTTLED_INFO("loop closed: " << revision.closures.size() << " closures, the robot moved by " << std::fixed
                                   << std::setprecision(3) << revision.T_new_old.position().norm() << " m and "
                                   << std::setprecision(2) << revision.T_new_old.yaw * 180.0 / kPi
                                   << " deg in the map");
    broadcast();
  }
  if (revision.map) old_ = std::make_shared<MapRevision>(std::move(thoughts.revision));
}

void MapperAdapter::note(ScanVerdict verdict, const std::string& detail) {
  if (!isDropped(verdict)) {
    last_inserted_ = steadyNow();
  } else {
    bad_scans_.add(detail.empty() ? toString(verdict) : std::string(toString(verdict)) + ", " + detail);
  }
}

void MapperAdapter::broadcast() {
  const Time stamp = rosNow() + fromSeconds(parameters_.tf_lead);
  tf_.broadcast(parameters_.map_frame, parameters_.odom_frame, mapper_.T_map_odom(), stamp);
}

}  // namespace frontier_pilot
