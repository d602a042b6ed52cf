#include "frontier_pilot/ros/map_mirror.h"

#include <algorithm>

#include "frontier_pilot/ros/conversions.h"
#include "frontier_pilot/ros/names.h"
#include "frontier_pilot/ros/throttled_log.h"

namespace frontier_pilot {

namespace {

void copy(const GridUpdate& update, OccupancyGrid& map) {
  const CellRect& rect = update.rect;
  for (int row = 0; row < rect.height; ++row) {
    std::copy_n(update.cells.data() + static_cast<std::ptrdiff_t>(row) * rect.width, rect.width,
                map.row(rect.y + row) + rect.x);
  }
}

}  // namespace

void MapMirror::subscribe(NodeConnections& connections, const std::string& frame) {
  frame_ = frame;
  map_subscriber_ = connections.subscribe(names::kMap, 1, &MapMirror::handleMap, this);
  connections.subscribe(names::kMapUpdates, 100, &MapMirror::handleUpdate, this);
}

bool MapMirror::rightFrame(const std::string& frame) {
  const bool right = frame_.empty() || frame == frame_;
  if (!right) rejections_.add("in frame '" + frame + "', not '" + frame_ + "'");
  return right;
}

void MapMirror::handleMap(const nav_msgs::OccupancyGrid& msg) {
  if (!rightFrame(msg.header.frame_id)) return;
  std::string why;
  auto map = toOccupancyGrid(msg, &why);
  if (!map) return rejections_.add(why);
  replace(std::move(*map));
  stamp_ = toTime(msg.header.stamp);
}

void MapMirror::replace(OccupancyGrid map) {
  const GridGeometry& was = map_.geometry();
  const GridGeometry& is = map.geometry();
  if (ready() && was == is) {
    changed_.include(difference(map_, map));
  } else {
    if (ready() && (is.width < was.width || is.height < was.height)) {
      THROTTLED_WARN("map shrank from " << was.width << " x " << was.height << " to " << is.width << " x " << is.height
                                        << " cells: the smaller one counts");
    }
    changed_ = is.rect();
  }
  map_ = std::move(map);
}

void MapMirror::handleUpdate(const map_msgs::OccupancyGridUpdate& msg) {
  if (!ready() || !rightFrame(msg.header.frame_id)) return;  // the latched map holds what an early update said
  std::string why;
  const auto update = toGridUpdate(msg, &why);
  if (!update) return rejections_.add(why);
  if (!(update->rect.intersection(map_.geometry().rect()) == update->rect)) {
    return rejections_.add("update reaches beyond the map");
  }
  copy(*update, map_);
  changed_.include(update->rect);
  stamp_ = toTime(msg.header.stamp);
}

CellRect MapMirror::takeChanged() { return std::exchange(changed_, CellRect{}); }

}  // namespace frontier_pilot
