#include <nav_msgs/Odometry.h>
#include <ros/serialization.h>
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
#include "ros/common/tf/frame_name.h"
#include "ros/common/tf/tf_listener.h"
#include "ros/map_log/bag_choice.h"
#include "ros/map_log/bag_log.h"

namespace frontier_pilot {
namespace {

constexpr const char* kReindex = "'rosbag reindex' may recover what it holds";

/// Goes through the messages of a bag and collects scans with their odometry.
class BagReading {
 public:
  /// `words` go before what is noticed in reading.
  BagReading(const tools::BagTopics& topics, const std::vector<std::string>& words) : topics_(topics) {
    log_.notes = words;
  }

  /// To be called before takeMessages, so that the scanner's mount is known for the first scan already.
  void takeTransforms(rosbag::View& view) {
    for (const rosbag::MessageInstance& message : view) {
      const auto transforms = message.instantiate<tf2_msgs::TFMessage>();
      if (!transforms) continue;
      const bool is_static = isSameTopic(message.getTopic(), names::kTfStatic);
      for (const auto& transform : transforms->transforms) takeTransform(transform, is_static);
    }
  }
  void takeMessages(rosbag::View& view) {
    nameFrames(view);
    for (const rosbag::MessageInstance& message : view) {
      if (isSameTopic(message.getTopic(), topics_.odom)) takeOdometry(message.instantiate<nav_msgs::Odometry>());
      if (isSameTopic(message.getTopic(), topics_.scan)) takeScan(message.instantiate<sensor_msgs::LaserScan>());
      collect(latest_);
    }
    collect(Time::max());
  }
  logs::ScanLog result() {
    if (anchor_.resets() > 0)
      log_.notes.push_back("jumps of odometry: " + std::to_string(anchor_.resets()) +
                           ", taken for restarts of the base's driver: the robot has stayed where it was");
    if (!timing_.problem().empty()) log_.notes.push_back(timing_.problem());
    if (other_mapper_ > 0)
      log_.notes.push_back("left out: " + std::to_string(other_mapper_) + " recorded transforms to " + odom_frame_ +
                           " of another mapper");
    for (std::string& hole : describeHoles("scans", scan_stamps_)) log_.notes.push_back(std::move(hole));
    for (const auto& [problem, count] : problems_) log_.notes.push_back(std::to_string(count) + " x " + problem);
    return std::move(log_);
  }

 private:
  void takeTransform(const geometry_msgs::TransformStamped& transform, bool is_static) {
    if (!isInRange(transform.header.stamp)) return reject("transform whose stamp is out of range");
    ++transforms_to_[plain(transform.child_frame_id)];
    // Only the mount of the scanner is needed. It is fixed, even if it is repeated on /tf; transforms of base_footprint
    // itself are not needed.
    const bool is_mount = is_static || transform.child_frame_id.find(names::kBaseFootprintFrame) == std::string::npos;
    if (is_mount) tf_.setTransform(transform, "bag", is_static);
  }
  /// By the first odometry, before the first scan, which often comes earlier.
  void nameFrames(rosbag::View& view) {
    for (const rosbag::MessageInstance& message : view) {
      if (!isSameTopic(message.getTopic(), topics_.odom)) continue;
      const auto msg = message.instantiate<nav_msgs::Odometry>();
      const auto first = msg ? toOdometry(*msg) : std::nullopt;
      if (!first) continue;
      latest_ = first->stamp;
      return begin(*msg);
    }
  }
  void takeOdometry(const nav_msgs::Odometry::ConstPtr& msg) {
    if (!msg) return reject("message on the odometry topic that is no odometry");
    std::string why;
    const auto odometry = toOdometry(*msg, &why);
    if (!odometry) return reject("odometry " + why);
    latest_ = odometry->stamp;
    if (!pairing_.addOdometry(odometry->stamp, odometry->T_odom_base, anchor_))
      reject(std::string("odometry ") + mapping::OdometryAnchor::kWithheld);
  }
  void begin(const nav_msgs::Odometry& first) {
    odom_frame_ = plain(first.header.frame_id);
    other_mapper_ = transforms_to_[odom_frame_];
    const std::string base = plain(first.child_frame_id);
    if (tf_._frameExists(topics_.base_frame) || !tf_._frameExists(base)) return;
    if (topics_.base_frame != tools::BagTopics().base_frame)
      log_.notes.push_back("no frame " + topics_.base_frame + " in the bag: the base is " + base +
                           ", as odometry says");
    topics_.base_frame = base;
  }
  void takeScan(const sensor_msgs::LaserScan::ConstPtr& msg) {
    if (!msg) return reject("message on the scan topic that is no scan");
    std::string why;
    scan_stamps_.push_back(msg->header.stamp.toSec());
    const auto T_base_sensor = mountOf(msg->header.frame_id, why);
    auto scan = T_base_sensor ? toLaserScan(*msg, *T_base_sensor, &why) : std::nullopt;
    if (!scan) return reject("scan " + why);
    timing_.apply(*scan);
    pairing_.addScan(std::move(*scan));
  }
  std::optional<Eigen::Isometry3d> mountOf(const std::string& frame, std::string& why) const {
    try {
      return toIsometry(tf_.lookupTransform(plain(topics_.base_frame), plain(frame), ros::Time()).transform, &why);
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
  mapping::OdometryAnchor anchor_;
  mapping::ScanPairing pairing_;
  BeamTiming timing_{ScannerModel()};
  Time latest_{};                                     ///< stamp of the latest odometry so far
  std::map<std::string, std::size_t> transforms_to_;  ///< number of recorded transforms by their child frame
  std::string odom_frame_;
  std::size_t other_mapper_ = 0;     ///< recorded transforms to `odom_frame_`
  std::vector<double> scan_stamps_;  ///< [s]
  logs::ScanLog log_;
  std::map<std::string, std::size_t> problems_;
};

std::string listed(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += "; " + note;
  return text;
}

}  // namespace

logs::ScanLog readBagLog(const std::string& path, const tools::BagTopics& wanted) {
  try {
    const rosbag::Bag bag(path);
    const BagChoice choice = chooseTopics(bag, wanted);
    const tools::BagTopics& topics = choice.topics;
    rosbag::View transforms(bag, [](const rosbag::ConnectionInfo* info) {
      return isSameTopic(info->topic, names::kTf) || isSameTopic(info->topic, names::kTfStatic);
    });
    rosbag::View messages(bag, [&](const rosbag::ConnectionInfo* info) {
      return isSameTopic(info->topic, topics.scan) || isSameTopic(info->topic, topics.odom);
    });
    BagReading reading(topics, choice.words);
    reading.takeTransforms(transforms);
    reading.takeMessages(messages);
    logs::ScanLog log = reading.result();
    logs::recogniseMissingReturns(log);
    if (!log.records.empty()) return log;
    throw logs::LogError(path + ": holds no usable scan on '" + topics.scan + "' with odometry on '" + topics.odom +
                         "'" + listed(log.notes));
  } catch (const rosbag::BagUnindexedException&) {
    throw logs::LogError(path + ": has no index, because its recording did not end in an orderly way; " + kReindex);
  } catch (const rosbag::BagIOException& error) {
    throw logs::LogError(path + ": is cut off, or cannot be read (" + error.what() + "); " + kReindex);
  } catch (const rosbag::BagException& error) {
    throw logs::LogError(path + ": " + error.what());
  } catch (const ros::serialization::StreamOverrunException&) {
    throw logs::LogError(path + ": is broken: a message is shorter than its type says");
  }
}

}  // namespace frontier_pilot
