#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/buffer.h>

#include <atomic>
#include <cstddef>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "frontier_pilot/core/clock_trust.h"
#include "ros/common/callback_guard.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/checked_subscription.h"
#include "ros/common/tf/stamp_order.h"

namespace frontier_pilot {

/// What is wrong with a transform; null if nothing is. A static one holds at any time.
const char* problemOf(const geometry_msgs::TransformStamped& transform, Time now, bool is_static);

/// Fills a TF buffer from /tf and /tf_static on a thread of its own, as tf2_ros::TransformListener does. Unlike that
/// one it refuses and counts what cannot be, keeps a bounded number of frames, forgets what the clock's jumps have
/// brought, and never throws. What is fixed stays: of two static transforms of one frame that differ the first holds,
/// for a scanner that is turned by a stranger's message would have the robot drive into walls. [FLT-1]
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
  bool mayKeep(const geometry_msgs::TransformStamped& transform);
  /// Whether the child's frame is fixed to another place already.
  bool contradictsAFixedOne(const geometry_msgs::TransformStamped& transform, bool is_static);
  /// Whether its stamp is to be believed; empties the buffer where that of the one before was not.
  bool isOfItsTime(const geometry_msgs::TransformStamped& transform, bool is_static, Time now);

  tf2_ros::Buffer& buffer_;
  ClockTrust trust_;
  StampOrder order_;
  CallbackGuard guard_;
  UnreadableMessages unreadable_;
  mutable std::mutex mutex_;  ///< of what is refused
  Rejections rejections_{"transform"};
  std::set<std::string> frames_;                                  ///< that the buffer knows
  std::map<std::string, geometry_msgs::TransformStamped> fixed_;  ///< the static ones, by child
  ros::CallbackQueue queue_;
  ros::NodeHandle node_;
  ros::Subscriber transforms_, static_transforms_;
  std::atomic<bool> ending_{false};
  std::thread thread_;  ///< the last member: everything else is there before it starts
};

}  // namespace frontier_pilot
