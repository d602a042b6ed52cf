#include "ros/check_robot/robot_observer.h"

#include <algorithm>
#include <utility>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/laser_scan.h"
#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/messages/message_problems.h"
#include "ros/common/names.h"
#include "ros/common/tf/frame_name.h"
#include "ros/common/tf/tf_listener.h"

namespace frontier_pilot {
namespace {

double usableShare(const sensor_msgs::LaserScan& msg) {
  if (msg.ranges.empty()) return 0.0;
  const auto usable = std::count_if(msg.ranges.begin(), msg.ranges.end(), [&](float range) {
    return readRange(range, static_cast<double>(msg.range_min), static_cast<double>(msg.range_max)).kind !=
           RangeKind::kInvalid;
  });
  return static_cast<double>(usable) / static_cast<double>(msg.ranges.size());
}

/// What nothing but a static transform may have.
std::string problemOf(const ros::Time& stamp) {
  return stamp.isZero() && !ros::Time::isSimTime() ? "its stamp is 0" : "";
}

}  // namespace

template <class Msg>
void RobotObserver::listen(ros::NodeHandle& node, const std::string& topic,
                           std::function<void(const Event<Msg>&)> handle) {
  constexpr std::uint32_t kQueue = 100;
  ros::SubscribeOptions options = checkedSubscription<Msg>(
      topic, kQueue, unreadable_,
      [this, topic, handle](const Event<Msg>& event) { guard_.run(topic, [&] { handle(event); }); },
      ros::TransportHints().tcpNoDelay());
  subscribers_.push_back(node.subscribe(options));
}

RobotObserver::RobotObserver(ros::NodeHandle& node) {
  listen<sensor_msgs::LaserScan>(node, names::kScan, [this](const auto& event) { takeScan(event); });
  listen<nav_msgs::Odometry>(node, names::kOdom, [this](const auto& event) { takeOdometry(event); });
  listen<tf2_msgs::TFMessage>(node, names::kTf, [this](const auto& event) { takeTransforms(event, false); });
  listen<tf2_msgs::TFMessage>(node, names::kTfStatic, [this](const auto& event) { takeTransforms(event, true); });
}

void RobotObserver::takeScan(const Event<sensor_msgs::LaserScan>& event) {
  const sensor_msgs::LaserScan& msg = *event.getConstMessage();
  const std::string problem = problemOf(msg);
  scan_.add(event.getPublisherName(), plain(msg.header.frame_id), msg.header.stamp,
            problem.empty() ? problemOf(msg.header.stamp) : problem);
  last_scan_.usable_share = usableShare(msg);
  last_scan_.beams = msg.ranges.size();
  last_scan_.angle_increment = static_cast<double>(msg.angle_increment);
  last_scan_.time_increment = static_cast<double>(msg.time_increment);
  if (auto scan = toLaserScan(msg, Eigen::Isometry3d::Identity())) last_scan_.last = std::move(scan);
}

void RobotObserver::takeOdometry(const Event<nav_msgs::Odometry>& event) {
  const nav_msgs::Odometry& msg = *event.getConstMessage();
  std::string why;
  if (toOdometry(msg, &why)) why = problemOf(msg.header.stamp);
  odometry_.add(event.getPublisherName(), plain(msg.header.frame_id), msg.header.stamp, why);
}

void RobotObserver::takeTransforms(const Event<tf2_msgs::TFMessage>& event, bool is_static) {
  for (const geometry_msgs::TransformStamped& transform : event.getConstMessage()->transforms) {
    const auto key = std::make_pair(plain(transform.child_frame_id), plain(transform.header.frame_id));
    if (links_.count(key) == 0 && links_.size() >= bounds::kMostFrames) continue;
    Link& link = links_[key];
    const char* why = problemOf(transform, rosNow(), is_static);
    const std::string problem = why != nullptr ? why : is_static ? "" : problemOf(transform.header.stamp);
    link.stream.add(event.getPublisherName(), {}, transform.header.stamp, problem);
    link.is_static = is_static;
    if (why == nullptr) link.T_parent_child = toIsometry(transform.transform);
  }
}

robot_check::Observation RobotObserver::observation() const {
  robot_check::Observation seen;
  seen.scan = last_scan_;
  static_cast<robot_check::Stream&>(seen.scan) = scan_.summary();
  seen.odometry = odometry_.summary();
  for (const auto& [names, link] : links_) {
    std::vector<robot_check::FrameLink>& links = link.T_parent_child ? seen.links : seen.useless_links;
    links.push_back({names.second, names.first, link.T_parent_child.value_or(Eigen::Isometry3d::Identity()),
                     link.is_static, link.stream.summary()});
  }
  return seen;
}

}  // namespace frontier_pilot
