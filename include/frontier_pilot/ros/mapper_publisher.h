#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>

#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot {

struct MapPublishingParameters {
  double min_period = 1.0;  ///< between two whole maps, at least [s]
  double max_period = 5.0;  ///< a change waits for a whole map no longer than this [s]

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("min_period", min_period, "s", "between two whole maps, at least", positive());
    v.field("max_period", max_period, "s", "a change waits for a whole map no longer than this", positive());
  }
};

/// Publishes the map: what changed at once, the whole of it seldom, and nothing while another node owns the topic.
/// [MAP-2] [MAP-3]
/// The whole map goes out when it has grown, when somebody new listens, when what was sent as updates since the last
/// one comes to as much, and else after a while: so that all in all publishing costs what changed, not the map's size.
/// It is kept as a message and patched.
class MapperPublisher {
 public:
  /// Nothing is advertised yet.
  MapperPublisher(const ros::NodeHandle& node, std::string frame, const MapPublishingParameters& parameters);

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
  void patch(const OccupancyGrid& grid, const MapChanges& changes);
  bool isDue(Time now) const;
  void publishWhole(Time now);

  ros::NodeHandle node_;
  std::string topic_;
  std::string frame_;
  MapPublishingParameters parameters_;
  std::string foreigners_;
  bool advertised_ = false;
  ros::Publisher map_;
  ros::Publisher updates_;
  ros::Publisher metadata_;
  nav_msgs::OccupancyGrid whole_;   ///< the map as it is
  std::optional<Time> last_whole_;  ///< when it went out last
  bool grown_ = true;               ///< since then its geometry has changed: updates would not fit
  std::size_t changed_ = 0;         ///< how many cells went out as updates since then
  bool newcomer_ = false;           ///< somebody has begun to listen since then
};

}  // namespace frontier_pilot
