#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <ros/serialization.h>

#include <string>

#include "frontier_pilot/core/time.h"
#include "frontier_pilot/occupancy/occupancy_map.h"

namespace frontier_pilot {

/// A whole map as nav_msgs/OccupancyGrid: the same on the wire, but its cells go straight from the map's tiles into the
/// buffer that is sent. The message itself would take as much memory again, a byte for each cell of the box around the
/// map, and the grid it is made of once more.
struct MapMessage {
  /// `map`, which must not be empty, must outlive the message.
  MapMessage(const occupancy::OccupancyMap& map, const std::string& frame, Time stamp);

  const occupancy::OccupancyMap& map;
  std_msgs::Header header;
  nav_msgs::MapMetaData info;
};

}  // namespace frontier_pilot

// The names and signatures in these namespaces are ROS'.
// NOLINTBEGIN(readability-identifier-naming)
namespace ros {
namespace message_traits {

template <>
struct MD5Sum<frontier_pilot::MapMessage> : MD5Sum<nav_msgs::OccupancyGrid> {
  using MD5Sum<nav_msgs::OccupancyGrid>::value;
  static const char* value(const frontier_pilot::MapMessage&) { return value(); }
};
template <>
struct DataType<frontier_pilot::MapMessage> : DataType<nav_msgs::OccupancyGrid> {
  using DataType<nav_msgs::OccupancyGrid>::value;
  static const char* value(const frontier_pilot::MapMessage&) { return value(); }
};
template <>
struct Definition<frontier_pilot::MapMessage> : Definition<nav_msgs::OccupancyGrid> {
  using Definition<nav_msgs::OccupancyGrid>::value;
  static const char* value(const frontier_pilot::MapMessage&) { return value(); }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<frontier_pilot::MapMessage> {
  template <class Stream>
  static void write(Stream& stream, const frontier_pilot::MapMessage& message) {
    const auto cells = static_cast<std::uint32_t>(message.map.geometry().size());
    stream.next(message.header);
    stream.next(message.info);
    stream.next(cells);
    message.map.copyTo(reinterpret_cast<std::int8_t*>(stream.advance(cells)));
  }
  static std::uint32_t serializedLength(const frontier_pilot::MapMessage& message) {
    return serializationLength(message.header) + serializationLength(message.info) +
           static_cast<std::uint32_t>(sizeof(std::uint32_t) + message.map.geometry().size());
  }
};

}  // namespace serialization
}  // namespace ros
// NOLINTEND(readability-identifier-naming)
