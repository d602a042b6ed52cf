#include "ros/common/maps/map_changes_publisher.h"

#include <frontier_pilot/MapChanges.h>

#include <algorithm>
#include <vector>

#include "ros/common/clock.h"
#include "ros/common/maps/run_lengths.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"

namespace frontier_pilot {
namespace {

constexpr double kPeriod = 60.0;          // of whole maps [s]
constexpr double kCellsPerSecond = 10e6;  // of whole maps; a core codes ten times as many
constexpr std::uint32_t kQueue = 20;      // for a connection that is slow for some seconds

MapChanges message(const GridGeometry& geometry, const std::string& frame, std::uint32_t sequence, Time now) {
  MapChanges msg;
  msg.header.frame_id = frame;
  msg.header.stamp = toRosTime(now);
  msg.info = toMapMetaDataMsg(geometry);
  msg.sequence = sequence;
  return msg;
}

MapBlock toMapBlockMsg(const CellRect& rect) {
  MapBlock msg;
  msg.x = static_cast<std::uint16_t>(rect.x);
  msg.y = static_cast<std::uint16_t>(rect.y);
  msg.width = static_cast<std::uint16_t>(rect.width);
  msg.height = static_cast<std::uint16_t>(rect.height);
  return msg;
}

}  // namespace

void MapChangesPublisher::advertise(ros::NodeHandle& node, const std::string& map, const std::string& frame) {
  frame_ = frame;
  const ros::SubscriberStatusCallback note = [this](const ros::SingleSubscriberPublisher&) { complete_ = false; };
  publisher_ = node.advertise<MapChanges>(names::changesOf(node.resolveName(map)), kQueue, note);
}

void MapChangesPublisher::publish(const GridGeometry& geometry, const CellRect& changed, const CellsIn& cells_in,
                                  Time now) {
  if (publisher_.getNumSubscribers() == 0) {
    complete_ = false;
    return;
  }
  if (geometry != sent_.geometry()) complete_ = false;
  const bool due = !complete_ || toSeconds(now - last_whole_) >= kPeriod || now < last_whole_;
  if (due && mayBeWhole(geometry, now)) return publishWhole(geometry, cells_in, now);
  if (geometry == sent_.geometry()) publishBlocks(changed, cells_in, now);
}

bool MapChangesPublisher::mayBeWhole(const GridGeometry& geometry, Time now) const {
  const double waited = toSeconds(now - last_whole_);
  return waited < 0.0 || waited * kCellsPerSecond >= static_cast<double>(geometry.size());
}

void MapChangesPublisher::publishWhole(const GridGeometry& geometry, const CellsIn& cells_in, Time now) {
  MapChanges msg = message(geometry, frame_, ++sequence_, now);
  msg.whole = 1;
  sent_.reset(geometry);
  RunWriter runs;
  // Not more than a row of blocks is copied at a time.
  for (int y = 0; y < geometry.height; y += BlockChanges::kSide) {
    const CellRect row{0, y, geometry.width, std::min(BlockChanges::kSide, geometry.height - y)};
    const OccupancyGrid part = cells_in(row);
    sent_.take(part, row);
    runs.add(part.row(0), part.size());
  }
  msg.runs = runs.take();
  publisher_.publish(msg);
  complete_ = true;
  last_whole_ = now;
}

void MapChangesPublisher::publishBlocks(const CellRect& changed, const CellsIn& cells_in, Time now) {
  const CellRect place = sent_.blocksAround(changed);
  if (place.empty()) return;
  const OccupancyGrid part = cells_in(place);
  const std::vector<CellRect> blocks = sent_.take(part, place);
  if (blocks.empty()) return;
  MapChanges msg = message(sent_.geometry(), frame_, ++sequence_, now);
  RunWriter runs;
  for (const CellRect& block : blocks) {
    msg.blocks.push_back(toMapBlockMsg(block));
    for (int y = block.y; y < block.y + block.height; ++y) {
      runs.add(part.row(y - place.y) + block.x - place.x, static_cast<std::size_t>(block.width));
    }
  }
  msg.runs = runs.take();
  publisher_.publish(msg);
}

}  // namespace frontier_pilot
