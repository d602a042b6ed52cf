#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2/buffer_core.h>
#include <tf2/exceptions.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <map>
#include <utility>

#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/mapping/scan_pairing.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/map_log/bag_log.h"

namespace frontier_pilot {
namespace {

/// Whether two names are the same topic: bags contain them with or without the leading slash.
bool isTopic(const std::string& name, const std::string& wanted) {
  const auto bare = [](const std::string& text) {
    return text.substr(std::min(text.find_first_not_of('/'), text.size()));
  };
  return !bare(wanted).empty() && bare(name) == bare(wanted);
}

/// Goes through the messages of a bag and collects scans with their odometry.
class BagReading {
 public:
  explicit BagReading(const tools::BagTopics& topics) : topics_(topics) {}

  /// To be called before takeMessages, so that the scanner's mount is known for the first scan already.
  void takeTransforms(rosbag::View& view) {
    for (const rosbag::MessageInstance& message : view) {
      const auto transforms = message.instantiate<tf2_msgs::TFMessage>();
      if (!transforms) continue;
      const bool is_static = isTopic(message.getTopic(), names::kTfStatic);
      for (const auto& transform : transforms->transforms) takeTransform(transform, is_static);
    }
  }
  void takeMessages(rosbag::View& view) {
    for (const rosbag::MessageInstance& message : view) {
      if (isTopic(message.getTopic(), topics_.odom)) takeOdometry(message.instantiate<nav_msgs::Odometry>());
      if (isTopic(message.getTopic(), topics_.scan)) takeScan(message.instantiate<sensor_msgs::LaserScan>());
      collect(latest_);
    }
    collect(Time::max());
  }
  logs::ScanLog result() {
    if (!timing_.problem().empty()) log_.notes.push_back(timing_.problem());
    for (const auto& [problem, count] : problems_) log_.notes.push_back(std::to_string(count) + " x " + problem);
    return std::move(log_);
  }

 private:
  void takeTransform(const geometry_msgs::TransformStamped& transform, bool is_static) {
    // Only the mount of the scanner is needed. It is fixed, even if it is repeated on /tf; transforms of base_footprint
    // itself are not needed.
    const bool is_mount = is_static || transform.child_frame_id.find(names::kBaseFootprintFrame) == std::string::npos;
    if (is_mount) tf_.setTransform(transform, "bag", is_static);
  }
  void takeOdometry(const nav_msgs::Odometry::ConstPtr& msg) {
    std::string why;
    const auto odometry = msg ? toOdometry(*msg, &why) : std::nullopt;
    if (!odometry) return reject("odometry " + why);
    latest_ = odometry->stamp;
    pairing_.addOdometry(odometry->stamp, odometry->T_odom_base);
  }
  void takeScan(const sensor_msgs::LaserScan::ConstPtr& msg) {
    if (!msg) return reject("message on the scan topic that is no scan");
    std::string why;
    const auto T_base_sensor = mountOf(msg->header.frame_id, why);
    auto scan = T_base_sensor ? toLaserScan(*msg, *T_base_sensor, &why) : std::nullopt;
    if (!scan) return reject("scan " + why);
    timing_.apply(*scan);
    pairing_.addScan(std::move(*scan));
  }
  std::optional<Eigen::Isometry3d> mountOf(const std::string& frame, std::string& why) const {
    try {
      return toIsometry(tf_.lookupTransform(topics_.base_frame, frame, ros::Time()).transform, &why);
    } catch (const tf2::TransformException& error) {
      why = error.what();
      return std::nullopt;
    }
  }
  void collect(Time now) {
    while (auto paired = pairing_.next(now)) {
      if (!paired->T_odom_base) {
        reject("scan without odometry for its stamp");
        continue;
      }
      log_.records.push_back({*paired->T_odom_base, std::move(paired->scan)});
    }
  }
  void reject(const std::string& problem) { ++problems_[problem]; }

  tools::BagTopics topics_;
  tf2::BufferCore tf_;
  mapping::ScanPairing pairing_;
  BeamTiming timing_{ScannerModel()};
  Time latest_{};  ///< stamp of the latest odometry so far
  logs::ScanLog log_;
  std::map<std::string, std::size_t> problems_;
};

std::string listed(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += "; " + note;
  return text;
}

}  // namespace

logs::ScanLog readBagLog(const std::string& path, const tools::BagTopics& topics) {
  try {
    const rosbag::Bag bag(path);
    rosbag::View transforms(bag, [](const rosbag::ConnectionInfo* info) {
      return isTopic(info->topic, names::kTf) || isTopic(info->topic, names::kTfStatic);
    });
    rosbag::View messages(bag, [&](const rosbag::ConnectionInfo* info) {
      return isTopic(info->topic, topics.scan) || isTopic(info->topic, topics.odom);
    });
    BagReading reading(topics);
    reading.takeTransforms(transforms);
    reading.takeMessages(messages);
    logs::ScanLog log = reading.result();
    logs::recogniseMissingReturns(log);
    if (!log.records.empty()) return log;
    throw logs::LogError(path + ": holds no usable scan on '" + topics.scan + "' with odometry on '" + topics.odom +
                         "'" + listed(log.notes));
  } catch (const rosbag::BagException& error) {
    throw logs::LogError(path + ": " + error.what());
  }
}

}  // namespace frontier_pilot
