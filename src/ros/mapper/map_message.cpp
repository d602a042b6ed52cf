#include "ros/mapper/map_message.h"

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"

namespace frontier_pilot {

MapMessage::MapMessage(const occupancy::OccupancyMap& whole, const std::string& frame, Time stamp) : map(whole) {
  const GridGeometry& geometry = whole.geometry();
  header.frame_id = frame;
  header.stamp = toRosTime(stamp);
  info.resolution = static_cast<float>(geometry.resolution);
  info.width = static_cast<std::uint32_t>(geometry.width);
  info.height = static_cast<std::uint32_t>(geometry.height);
  info.origin = toPoseMsg(Pose2(geometry.origin, 0.0));
}

}  // namespace frontier_pilot
