#include "ros/mapper/mapper_publisher.h"

#include <nav_msgs/MapMetaData.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>

#include <utility>

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/throttled_log.h"
#include "ros/mapper/map_message.h"

namespace frontier_pilot {

MapperPublisher::MapperPublisher(const ros::NodeHandle& node, std::string frame,
                                 const mapping::MapScheduleParameters& schedule)
    : node_(node), topic_(names::kMap), frame_(std::move(frame)), schedule_(schedule) {
  replaced_ = node_.advertise<std_msgs::String>(names::kMapReplaced, 10);
  advertiseLocalized();  // long before the map, so that whoever reads both is connected by then
}

void MapperPublisher::advertiseLocalized() { localized_ = node_.advertise<std_msgs::Bool>(names::kLocalized, 1, true); }

void MapperPublisher::setOther(const std::string& node) {
  if (!node.empty() && node != other_) {
    THROTTLED_ERROR(node << " publishes " << topic() << " as well; this mapper keeps silent");
  }
  other_ = node;
  if (node.empty()) {
    advertise();
  } else {
    withdraw();
  }
}

void MapperPublisher::advertise() {
  if (advertised_) return;
  const ros::SubscriberStatusCallback note = [this](const ros::SingleSubscriberPublisher&) {
    schedule_.noteNewcomer();
  };
  if (!localized_) advertiseLocalized();
  compact_.advertise(node_, topic_, frame_);  // first, so that the master never lists a mapper that has only `map`
  map_ = node_.advertise<nav_msgs::OccupancyGrid>(topic_, 1, note, {}, {}, true);
  updates_ = node_.advertise<map_msgs::OccupancyGridUpdate>(names::kMapUpdates, 10);
  metadata_ = node_.advertise<nav_msgs::MapMetaData>(names::kMapMetadata, 1, true);
  advertised_ = true;
}

void MapperPublisher::withdraw() {
  localized_.shutdown();
  found_at_.reset();
  said_localized_ = false;  // until its own transforms are in force again, a lookup may still return the other node's
  said_at_ = {};
  if (!advertised_) return;
  map_.shutdown();
  updates_.shutdown();
  metadata_.shutdown();
  compact_.withdraw();
  advertised_ = false;
  schedule_.reset();
}

void MapperPublisher::publish(mapping::Mapper& mapper, Time now) {
  const occupancy::OccupancyMap& map = mapper.map();
  if (!advertised_ || map.empty()) return;
  has_published_ = true;
  const occupancy::MapChanges changes = mapper.takeChanges();
  compact_.publish(
      map.geometry(), changes.cells, [&map](const CellRect& cells) { return map.projection(cells); }, now);
  if (schedule_.note(changes, now)) publishChanges(map, changes.cells, now);
  if (schedule_.isDue(map.geometry().size(), now)) publishWhole(map, now);
}

void MapperPublisher::announceReplacement(const std::string& why) {
  if (!other_.empty() && !has_published_) return;
  std_msgs::String msg;
  msg.data = why;
  replaced_.publish(msg);
}

void MapperPublisher::publishLost() {
  if (!advertised_) return;
  found_at_.reset();
  sayLocalized(false);
}

void MapperPublisher::publishLocalized(Duration lead) {
  if (!advertised_) return;
  const Time ros_now = rosNow();
  if (!found_at_ || ros_now < *found_at_) found_at_ = ros_now;
  const bool was_lost = said_localized_ == std::optional<bool>(false);
  sayLocalized(!was_lost || ros_now - *found_at_ > lead);
}

void MapperPublisher::sayLocalized(bool localized) {
  const SteadyTime now = steadyNow();
  if (said_localized_ == localized && now - said_at_ < std::chrono::seconds(1)) return;
  said_localized_ = localized;
  said_at_ = now;
  std_msgs::Bool msg;
  msg.data = static_cast<std::uint8_t>(localized);
  localized_.publish(msg);
}

void MapperPublisher::publishChanges(const occupancy::OccupancyMap& map, const CellRect& cells, Time now) {
  if (updates_.getNumSubscribers() == 0) return;
  const OccupancyGrid block = map.projection(cells);
  map_msgs::OccupancyGridUpdate update = toGridUpdateMsg(block, block.geometry().rect(), frame_, now);
  update.x = cells.x;
  update.y = cells.y;
  updates_.publish(update);
}

void MapperPublisher::publishWhole(const occupancy::OccupancyMap& map, Time now) {
  const MapMessage whole(map, frame_, now);
  map_.publish(whole);
  if (schedule_.sent(now)) metadata_.publish(whole.info);
}

}  // namespace frontier_pilot
