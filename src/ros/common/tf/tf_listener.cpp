#include "ros/common/tf/tf_listener.h"

#include <ros/console.h>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/clock.h"
#include "ros/common/clock_monitor.h"
#include "ros/common/messages/checked_subscription.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/tf/frame_name.h"

namespace frontier_pilot {

namespace {

constexpr double kListenPeriod = 0.01;                   // [s]
constexpr std::uint32_t kTfQueue = 100;                  // as in tf2_ros::TransformListener
constexpr Duration kMargin = std::chrono::seconds(600);  // before the end of ROS time, for what tf2 adds to a stamp

bool isPrintable(const std::string& frame) { return printable(frame, bounds::kMostName) == frame; }

}  // namespace

bool isInRange(const ros::Time& stamp) {
  return stamp.nsec < 1'000'000'000U && toTime(stamp) <= toTime(ros::TIME_MAX) - kMargin;
}

const char* problemOf(const geometry_msgs::TransformStamped& transform, Time now, bool is_static) {
  const std::string parent = plain(transform.header.frame_id);
  const std::string child = plain(transform.child_frame_id);
  if (parent.empty() || child.empty()) return "frame without a name";
  if (parent.size() > bounds::kMostName || child.size() > bounds::kMostName)
    return "frame's name longer than 256 characters";
  if (!isPrintable(parent) || !isPrintable(child)) return "control characters in a frame's name";
  if (parent == child) return "frame that is its own parent";
  if (!toIsometry(transform.transform)) return "not finite, farther than 1000 km, or its quaternion not of unit length";
  if (!isInRange(transform.header.stamp)) return "stamp out of range";
  if (!is_static && isAhead(toTime(transform.header.stamp), now)) return "stamp too far in the future";
  return nullptr;
}

TfListener::TfListener(tf2_ros::Buffer& buffer)
    : buffer_(buffer), trust_(clockPace()), order_(toDuration(buffer.getCacheLength())) {
  node_.setCallbackQueue(&queue_);
  const auto listen = [this](const std::string& topic, bool is_static) {
    ros::SubscribeOptions options = checkedSubscription<tf2_msgs::TFMessage>(
        topic, kTfQueue, unreadable_,
        [this, topic, is_static](const ros::MessageEvent<const tf2_msgs::TFMessage>& event) {
          guard_.run(topic, [&] { take(*event.getConstMessage(), is_static); });
        });
    return node_.subscribe(options);
  };
  transforms_ = listen("/tf", false);
  static_transforms_ = listen("/tf_static", true);
  thread_ = std::thread(&TfListener::run, this);
}

TfListener::~TfListener() {
  ending_ = true;
  thread_.join();
  transforms_.shutdown();
  static_transforms_.shutdown();
}

void TfListener::run() {
  while (!ending_) {
    guard_.run("tf", [this] {
      watchClock();
      queue_.callAvailable(ros::WallDuration(kListenPeriod));
    });
  }
}

void TfListener::watchClock() {
  // Static transforms stay in the buffer: they hold at any time.
  if (trust_.observe({rosNow(), steadyNow()}) == TrustChange::kNone) return;
  buffer_.clear();
  order_.clear();
}

void TfListener::take(const tf2_msgs::TFMessage& msg, bool is_static) {
  watchClock();
  const Time now = rosNow();
  std::size_t taken = 0;
  for (const geometry_msgs::TransformStamped& transform : msg.transforms) {
    if (++taken > bounds::kMostFrames) return refuse("beyond the first 1000 of a message");
    if (const char* why = problemOf(transform, now, is_static)) {
      refuse(why);
    } else if (const std::string objection = fixed_.objection(transform, is_static, steadyNow()); !objection.empty()) {
      refuse(objection);
      if (const std::string child = fixed_.takeDisputed(); !child.empty()) {
        detach(child);
        ROS_ERROR_STREAM(objection);
      }
    } else if (!mayKeep(transform)) {
      refuse("more than 1000 frames");
    } else if (isOfItsTime(transform, is_static, now)) {
      buffer_.setTransform(transform, "", is_static);
    }
  }
}

bool TfListener::isOfItsTime(const geometry_msgs::TransformStamped& transform, bool is_static, Time now) {
  if (is_static) return true;
  const std::string child = plain(transform.child_frame_id);
  switch (order_.judge(child, toTime(transform.header.stamp), now)) {
    case StampOrder::Verdict::kKeep:
      return true;
    case StampOrder::Verdict::kRepeated:
      refuse("'" + child + "' has this stamp already: is it published twice?");
      return false;
    case StampOrder::Verdict::kTooOld:
      refuse("older than the TF buffer keeps");
      return false;
    case StampOrder::Verdict::kForgetAndKeep:
      refuse("'" + child + "' had a stamp in the future: all earlier transforms are dropped");
      buffer_.clear();
      return true;
    case StampOrder::Verdict::kTooMany:
      refuse("'" + child + "' has more than 20000 transforms in ten seconds: all earlier transforms are dropped");
      buffer_.clear();
      return true;
  }
  return false;
}

void TfListener::refuse(const std::string& why) {
  const std::lock_guard<std::mutex> lock(mutex_);
  rejections_.add(why);
}

void TfListener::detach(const std::string& child) {
  geometry_msgs::TransformStamped nowhere;
  nowhere.header.frame_id = "disputed/" + child;
  nowhere.child_frame_id = child;
  nowhere.transform.rotation.w = 1.0;
  buffer_.setTransform(nowhere, "", true);
}

bool TfListener::mayKeep(const geometry_msgs::TransformStamped& transform) {
  for (const std::string& frame : {plain(transform.header.frame_id), plain(transform.child_frame_id)}) {
    if (frames_.count(frame) > 0) continue;
    if (frames_.size() >= bounds::kMostFrames) return false;
    frames_.insert(frame);
  }
  return true;
}

void TfListener::report(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  unreadable_.report(status);
  const std::lock_guard<std::mutex> lock(mutex_);
  rejections_.report(status);
}

}  // namespace frontier_pilot
