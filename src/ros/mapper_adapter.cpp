#include "frontier_pilot/ros/mapper_adapter.h"

#include <ros/console.h>

#include "frontier_pilot/mapping/map_io.h"
#include "frontier_pilot/ros/clock.h"
#include "frontier_pilot/ros/conversions.h"
#include "frontier_pilot/ros/parameters.h"

namespace frontier_pilot {

MapperAdapter::MapperAdapter(ros::NodeHandle& node, ros::NodeHandle& private_node)
    : parameters_(loadNodeParameters<MapperNodeParameters>(private_node)),
      mapper_(parameters_.mapper),
      pairing_(parameters_.pairing),
      publisher_(node, parameters_.map_frame, parameters_.map_period),
      watch_({publisher_.topic()}, std::chrono::seconds(2)),
      diagnostics_(node, private_node) {
  diagnostics_.add("mapping", [this](Status& status) { report(status); });
  advertiseServices(node);
  odometry_subscriber_ = node.subscribe(names::kOdom, 100, &MapperAdapter::handleOdometry, this);
  scan_subscriber_ = node.subscribe(names::kScan, 20, &MapperAdapter::handleScan, this);
  update_timer_ = node.createTimer(ros::Duration(parameters_.update_period), [this](const ros::TimerEvent&) {
    insertPaired();
    publisher_.publish(mapper_, rosNow());
  });
  tf_timer_ = node.createTimer(ros::Duration(parameters_.tf_period), [this](const ros::TimerEvent&) { broadcast(); });
  watch_timer_ = node.createSteadyTimer(ros::WallDuration(0.1), [this](const ros::SteadyTimerEvent&) {
    if (const auto found = watch_.take()) publisher_.setPublishers(found->at(publisher_.topic()));
  });
}

void MapperAdapter::advertiseServices(ros::NodeHandle& node) {
  services_ = {node.advertiseService(names::kDynamicMap, &MapperAdapter::handleGet, this),
               node.advertiseService(names::kSaveMap, &MapperAdapter::handleSave, this),
               node.advertiseService(names::kResetMap, &MapperAdapter::handleReset, this)};
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
    mapper_.reject(verdict);
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

bool MapperAdapter::handleSave(SaveMap::Request& request, SaveMap::Response& response) {
  const MapIoResult result = saveMap(mapper_.map(), request.path);
  response.success = static_cast<std::uint8_t>(result.ok());
  response.message = result.text;
  if (result.ok()) {
    ROS_INFO_STREAM(result.text);
  } else {
    ROS_ERROR_STREAM("map not saved, " << toString(result.status) << ": " << result.text);
  }
  return true;
}

bool MapperAdapter::handleGet(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response) {
  // The response has no field to say so: without a map the call fails.
  if (mapper_.grid().empty()) return false;
  response.map = toOccupancyGridMsg(mapper_.grid(), parameters_.map_frame, rosNow());
  return true;
}

bool MapperAdapter::handleReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  mapper_.reset();
  response.success = 1U;
  response.message = "the map is forgotten; its size stays";
  return true;
}

void MapperAdapter::report(Status& status) const {
  summarize(status);
  for (std::size_t i = 0; i < kScanVerdicts; ++i) {
    const auto verdict = static_cast<ScanVerdict>(i);
    status.add(std::string("scans, ") + toString(verdict), mapper_.counts()[verdict]);
  }
  status.add("scans dropped", mapper_.counts().dropped());
  bad_scans_.report(status);
  bad_odometry_.report(status);
  const GridGeometry& geometry = mapper_.grid().geometry();
  status.addf("map size [m]", "%.1f x %.1f", geometry.width * geometry.resolution,
              geometry.height * geometry.resolution);
}

void MapperAdapter::summarize(Status& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  status.summary(DiagnosticStatus::OK, "mapping");
  if (!last_inserted_) {
    status.summary(DiagnosticStatus::WARN, pairing_.hasOdometry() ? "no usable scan yet" : "no odometry yet");
  } else if (toSeconds(steadyNow() - *last_inserted_) > parameters_.silence) {
    status.summary(DiagnosticStatus::WARN, "no usable scan any more");
  }
  if (!publisher_.foreigners().empty()) {
    status.summary(DiagnosticStatus::ERROR,
                   "another node publishes " + publisher_.topic() + ": " + publisher_.foreigners());
  }
}

}  // namespace frontier_pilot
