#pragma once

#include <ros/subscriber.h>

#include <optional>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/core/time.h"
#include "ros/common/node_connections.h"

namespace frontier_pilot {

/// What the mapper says on `mapper/localized`: whether the robot is where its pose on the map is. Without a mapper that
/// says so, as with another SLAM or with AMCL, that is taken for granted. [MAP-5]
class LocalizationInput {
 public:
  /// The node also waits for it, if it is `need`ed. `connections` must outlive this.
  void subscribe(NodeConnections& connections, Need need = Need::kNeeded);
  bool isLocalized() const;
  /// Whether that holds for `pose`, the latest that is known: not if it is of before the robot was found.
  bool isLocalizedAt(const std::optional<StampedPose2>& pose) const;

 private:
  void take(bool localized);

  const NodeConnections* connections_ = nullptr;
  ros::Subscriber subscriber_;
  bool localized_ = true;         ///< as it was said last
  std::optional<Time> found_at_;  ///< when it was said after the robot had not been localised
};

}  // namespace frontier_pilot
