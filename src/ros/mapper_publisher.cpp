#include "frontier_pilot/ros/mapper_publisher.h"

#include <nav_msgs/MapMetaData.h>
#include <ros/console.h>
#include <ros/this_node.h>

#include <utility>

#include "frontier_pilot/ros/conversions.h"
#include "frontier_pilot/ros/names.h"

namespace frontier_pilot {

MapperPublisher::MapperPublisher(const ros::NodeHandle& node, std::string frame, double period)
    : node_(node), topic_(names::kMap), frame_(std::move(frame)), period_(fromSeconds(period)) {}

void MapperPublisher::setPublishers(const std::vector<std::string>& publishers) {
  std::string others;
  for (const std::string& name : publishers) {
    if (name != ros::this_node::getName()) others += (others.empty() ? "" : ", ") + name;
  }
  if (!others.empty() && others != foreigners_) {
    ROS_ERROR_STREAM("another node publishes " << topic() << ": " << others << "; this mapper keeps silent");
  }
  foreigners_ = others;
  if (others.empty()) {
    advertise();
  } else {
    withdraw();
  }
}

void MapperPublisher::advertise() {
  if (advertised_) return;
  map_ = node_.advertise<nav_msgs::OccupancyGrid>(topic_, 1, true);
  updates_ = node_.advertise<map_msgs::OccupancyGridUpdate>(names::kMapUpdates, 10);
  metadata_ = node_.advertise<nav_msgs::MapMetaData>(names::kMapMetadata, 1, true);
  advertised_ = true;
}

void MapperPublisher::withdraw() {
  if (!advertised_) return;
  map_.shutdown();
  updates_.shutdown();
  metadata_.shutdown();
  advertised_ = false;
  last_whole_.reset();
  grown_ = true;
}

void MapperPublisher::publish(Mapper& mapper, Time now) {
  if (!advertised_ || mapper.grid().empty()) return;
  const MapChanges changes = mapper.takeChanges();
  grown_ = grown_ || changes.geometry_changed;
  changed_ = changed_ || !changes.empty();
  // What changes while a grown map waits for its turn goes out with it.
  if (!grown_ && !changes.cells.empty()) updates_.publish(toGridUpdateMsg(mapper.grid(), changes.cells, frame_, now));
  if ((grown_ || changed_) && isDue(now)) publishWhole(mapper.grid(), now);
}

bool MapperPublisher::isDue(Time now) const {
  // A clock that was set back must not hold the map.
  return !last_whole_ || now < *last_whole_ || now - *last_whole_ >= period_;
}

void MapperPublisher::publishWhole(const OccupancyGrid& grid, Time now) {
  const nav_msgs::OccupancyGrid msg = toOccupancyGridMsg(grid, frame_, now);
  map_.publish(msg);
  if (grown_) metadata_.publish(msg.info);
  last_whole_ = now;
  grown_ = false;
  changed_ = false;
}

}  // namespace frontier_pilot
