#pragma once

#include <ros/node_handle.h>

#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot {

/// Publishes the map: what changed at once, the whole of it seldom, and nothing while another node owns the topic.
/// [MAP-2] [MAP-3]
class MapperPublisher {
 public:
  /// `period` [s]: the whole map goes out at most this often. Nothing is advertised yet.
  MapperPublisher(const ros::NodeHandle& node, std::string frame, double period);

  /// The topic, resolved.
  std::string topic() const { return node_.resolveName(topic_); }
  /// Who publishes on the topic: advertises when it is nobody else, withdraws when it is.
  void setPublishers(const std::vector<std::string>& publishers);
  /// The others that publish on the topic, as a list; empty when the map is ours.
  const std::string& foreigners() const { return foreigners_; }

  void publish(Mapper& mapper, Time now);

 private:
  void advertise();
  void withdraw();
  bool isDue(Time now) const;
  void publishWhole(const OccupancyGrid& grid, Time now);

  ros::NodeHandle node_;
  std::string topic_;
  std::string frame_;
  Duration period_;
  std::string foreigners_;
  bool advertised_ = false;
  ros::Publisher map_;
  ros::Publisher updates_;
  ros::Publisher metadata_;
  std::optional<Time> last_whole_;  ///< when the whole map went out last
  bool grown_ = true;               ///< since then its geometry has changed: updates would not fit
  bool changed_ = true;             ///< since then something has changed
};

}  // namespace frontier_pilot
