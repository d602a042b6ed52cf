#pragma once

#include <ros/subscriber.h>

#include <string>

#include "ros/common/node_connections.h"

namespace frontier_pilot {

/// What the mapper says on `mapper/localized`: whether the robot is where its pose on the map is. Without a mapper that
/// says so, as with another SLAM or with AMCL, that is taken for granted. [MAP-5]
class LocalizationInput {
 public:
  /// The node also waits for it. `connections` must outlive this.
  void subscribe(NodeConnections& connections);
  bool isLocalized() const;

 private:
  const NodeConnections* connections_ = nullptr;
  ros::Subscriber subscriber_;
  bool localized_ = true;  ///< as it was said last
};

}  // namespace frontier_pilot
