#include "ros/mapper/mapper_publisher.h"

#include <nav_msgs/MapMetaData.h>

#include <algorithm>
#include <utility>

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {

MapperPublisher::MapperPublisher(const ros::NodeHandle& node, std::string frame,
                                 const mapping::MapScheduleParameters& schedule)
    : node_(node), topic_(names::kMap), frame_(std::move(frame)), schedule_(schedule) {}

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
  map_ = node_.advertise<nav_msgs::OccupancyGrid>(topic_, 1, note, {}, {}, true);
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
  schedule_.reset();
}

void MapperPublisher::publish(mapping::Mapper& mapper, Time now) {
  if (!advertised_ || mapper.grid().empty()) return;
  const occupancy::MapChanges changes = mapper.takeChanges();
  patch(mapper.grid(), changes);
  if (schedule_.note(changes, now)) {
    updates_.publish(toGridUpdateMsg(mapper.grid(), changes.cells, frame_, now));
  }
  if (schedule_.isDue(whole_.data.size(), now)) publishWhole(now);
}

void MapperPublisher::patch(const OccupancyGrid& grid, const occupancy::MapChanges& changes) {
  if (changes.geometry_changed || whole_.data.size() != grid.size()) {
    whole_ = toOccupancyGridMsg(grid, frame_, Time{});
    return;
  }
  const CellRect& rect = changes.cells;
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    const auto offset = static_cast<std::ptrdiff_t>(grid.geometry().index({rect.x, y}));
    std::copy_n(grid.row(y) + rect.x, rect.width, whole_.data.begin() + offset);
  }
}

void MapperPublisher::publishWhole(Time now) {
  whole_.header.stamp = toRosTime(now);
  map_.publish(whole_);
  if (schedule_.sent(now)) metadata_.publish(whole_.info);
}

}  // namespace frontier_pilot
