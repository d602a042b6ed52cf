#pragma once

#include <tf2_ros/buffer.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"
#include "ros/common/tf/tf_listener.h"

namespace frontier_pilot {

/// The pose of the frame `source` in the frame `target`.
struct FramePose {
  std::string target, source;
  Pose2 T_target_source;
};

/// The nodes' access to TF. A lookup that fails gives std::nullopt, never the identity.
class TfBridge {
 public:
  TfBridge();

  /// `T_target_source` at `stamp`; Time{} means the latest available. Waits for it at most `timeout` of steady time, so
  /// that a simulated clock that stands still cannot block the node. `why`, if given, receives TF's error message.
  std::optional<Pose2> lookup(const std::string& target, const std::string& source, Time stamp,
                              Duration timeout = Duration::zero(), std::string* why = nullptr) const;
  /// The same in three dimensions, for a sensor's mount.
  std::optional<Eigen::Isometry3d> lookup3d(const std::string& target, const std::string& source, Time stamp,
                                            Duration timeout = Duration::zero(), std::string* why = nullptr) const;
  /// The stamp of the latest `T_target_source`, for judging its age.
  std::optional<Time> latestStamp(const std::string& target, const std::string& source) const;
  /// T_target_source by the latest transform; nothing if that is older than `oldest`. Static ones do not age, and a
  /// frame is always at itself.
  std::optional<Pose2> latest(const std::string& target, const std::string& source, Duration oldest) const;
  /// All frames that are known.
  std::set<std::string> frames() const;

  /// Publishes `T_target_source` of each pose in one message: `target` becomes the parent of `source`. Only once for
  /// each stamp, because TF keeps the first and warns of others, and a timer that catches up with a simulated clock may
  /// tick several times at one stamp.
  void broadcast(const std::vector<FramePose>& poses, Time stamp);
  void broadcast(const std::string& target, const std::string& source, const Pose2& T_target_source, Time stamp) {
    broadcast({{target, source, T_target_source}}, stamp);
  }
  /// Publishes a static transform (latched); `height` is the z coordinate of `source` in `target` [m].
  void broadcastStatic(const std::string& target, const std::string& source, const Pose2& T_target_source,
                       double height = 0.0);

  /// For /diagnostics: which transforms were refused.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const { listener_.report(status); }

 private:
  tf2_ros::Buffer buffer_;
  TfListener listener_;
  tf2_ros::TransformBroadcaster broadcaster_;
  tf2_ros::StaticTransformBroadcaster static_broadcaster_;
  std::map<std::string, Time> sent_;  ///< the last stamp sent, by `source` frame
};

}  // namespace frontier_pilot
