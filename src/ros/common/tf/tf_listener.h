#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/buffer.h>

#include <atomic>
#include <cstddef>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "frontier_pilot/core/clock_trust.h"
#include "ros/common/callback_guard.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/checked_subscription.h"
#include "ros/common/tf/fixed_frames.h"
#include "ros/common/tf/stamp_order.h"

namespace frontier_pilot {

/// Whether tf2 can compute with `stamp`; with another one it throws.
bool isInRange(const ros::Time& stamp);
/// What is wrong with a transform; null if nothing is. The stamp of a static one may lie in the future.
const char* problemOf(const geometry_msgs::TransformStamped& transform, Time now, bool is_static);

/// Fills a TF buffer from /tf and /tf_static on a thread of its own, as tf2_ros::TransformListener does. Unlike that
/// one it refuses and counts invalid transforms, keeps a bounded number of frames, clears the buffer when the clock
/// jumps, and never throws. [FLT-1]
class TfListener {
 public:
  explicit TfListener(tf2_ros::Buffer& buffer);
  ~TfListener();
  TfListener(const TfListener&) = delete;
  TfListener& operator=(const TfListener&) = delete;

  /// For /diagnostics: what was refused.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  void run();
  void watchClock();
  void take(const tf2_msgs::TFMessage& msg, bool is_static);
  void refuse(const std::string& why);
  /// Lets the buffer know nothing of where `child` is, which tf2 does not forget once it is fixed.
  void detach(const std::string& child);
  bool mayKeep(const geometry_msgs::TransformStamped& transform);
  /// Whether its stamp is plausible. If an earlier stamp turns out to have been in the future, the buffer is cleared.
  bool isOfItsTime(const geometry_msgs::TransformStamped& transform, bool is_static, Time now);

  tf2_ros::Buffer& buffer_;
  ClockTrust trust_;
  StampOrder order_;
  CallbackGuard guard_;
  UnreadableMessages unreadable_;
  mutable std::mutex mutex_;  ///< guards the rejections
  Rejections rejections_{"transform"};
  std::set<std::string> frames_;  ///< known to the buffer
  FixedFrames fixed_;
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber transforms_, static_transforms_;
  std::atomic<bool> ending_{false};
  std::thread thread_;  ///< the last member: it starts when all others are constructed
};

}  // namespace frontier_pilot
