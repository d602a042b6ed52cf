#include "ros/mapper/map_message.h"

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"

namespace frontier_pilot {

MapMessage::MapMessage(const occupancy::OccupancyMap& whole, const std::string& frame, Time stamp) : map(whole) {
  header.frame_id = frame;
  header.stamp = toRosTime(stamp);
  info = toMapMetaDataMsg(whole.geometry());
}

}  // namespace frontier_pilot
