#include "ros/map_merger/grid_publisher.h"

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/MapMetaData.h>
#include <nav_msgs/OccupancyGrid.h>

#include <algorithm>
#include <utility>

#include "ros/common/messages/conversions.h"

namespace frontier_pilot {
namespace {

OccupancyGrid part(const OccupancyGrid& map, const CellRect& rect) {
  OccupancyGrid cells({map.resolution(), map.geometry().origin, rect.width, rect.height});
  for (int y = 0; y < rect.height; ++y) std::copy_n(map.row(rect.y + y) + rect.x, rect.width, cells.row(y));
  return cells;
}

}  // namespace

GridPublisher::GridPublisher(ros::NodeHandle& node, const MapTopics& topics, std::string frame,
                             const mapping::MapScheduleParameters& schedule)
    : frame_(std::move(frame)), schedule_(schedule) {
  const ros::SubscriberStatusCallback note = [this](const ros::SingleSubscriberPublisher&) {
    schedule_.noteNewcomer();
  };
  compact_.advertise(node, topics.map, frame_);  // first, as the mapper does
  map_ = node.advertise<nav_msgs::OccupancyGrid>(topics.map, 1, note, {}, {}, true);
  updates_ = node.advertise<map_msgs::OccupancyGridUpdate>(topics.updates, 10);
  metadata_ = node.advertise<nav_msgs::MapMetaData>(topics.metadata, 1, true);
}

void GridPublisher::publish(const OccupancyGrid& map, const CellRect& changed, Time now) {
  if (map.empty()) return;
  const bool grown = map.geometry() != geometry_;
  geometry_ = map.geometry();
  compact_.publish(
      map.geometry(), changed, [&map](const CellRect& cells) { return part(map, cells); }, now);
  const bool sends_changes = schedule_.note({grown, changed}, now);
  if (sends_changes && updates_.getNumSubscribers() > 0) updates_.publish(toGridUpdateMsg(map, changed, frame_, now));
  if (!schedule_.isDue(map.size(), now)) return;
  const nav_msgs::OccupancyGrid whole = toOccupancyGridMsg(map, frame_, now);
  map_.publish(whole);
  if (schedule_.sent(now)) metadata_.publish(whole.info);
}

}  // namespace frontier_pilot
