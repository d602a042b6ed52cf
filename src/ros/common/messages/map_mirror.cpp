#include "ros/common/messages/map_mirror.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "frontier_pilot/core/bounds.h"
#include "ros/common/clock.h"
#include "ros/common/maps/map_changes.h"
#include "ros/common/tf/frame_name.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {

namespace {

void copy(const GridUpdate& update, OccupancyGrid& map) {
  const CellRect& rect = update.rect;
  for (int row = 0; row < rect.height; ++row) {
    std::copy_n(update.cells.data() + static_cast<std::ptrdiff_t>(row) * rect.width, rect.width,
                map.row(rect.y + row) + rect.x);
  }
}

bool isInside(const CellRect& rect, const OccupancyGrid& map) {
  return rect.intersection(map.geometry().rect()) == rect;
}

}  // namespace

void RecentUpdates::add(Time stamp, GridUpdate update) {
  cells_ += update.cells.size();
  updates_.push_back({stamp, std::move(update)});
  while (updates_.size() > bounds::kMostRecentUpdates || cells_ > bounds::kMostRecentCells) {
    lost_ = updates_.front().stamp;
    cells_ -= updates_.front().update.cells.size();
    updates_.pop_front();
  }
}

void RecentUpdates::dropBefore(Time stamp) {
  while (!updates_.empty() && updates_.front().stamp < stamp) {
    cells_ -= updates_.front().update.cells.size();
    updates_.pop_front();
  }
}

std::optional<Time> RecentUpdates::applyTo(OccupancyGrid& map) const {
  std::optional<Time> last;
  for (const Stamped& recent : updates_) {
    if (!isInside(recent.update.rect, map)) continue;
    copy(recent.update, map);
    last = recent.stamp;
  }
  return last;
}

bool MapMirror::rightFrame(const std::string& frame) {
  const bool right = frame_.empty() || isSameFrame(frame, frame_);
  if (!right) rejections_.add("in frame '" + frame + "', not '" + frame_ + "'");
  return right;
}

void MapMirror::refuse(const std::string& publisher) {
  rejections_.add("from " + publisher + ", while " + owner_.name() + " publishes the map");
}

bool MapMirror::ownerLives() {
  if (connections_ == nullptr) return false;
  return owner_.lives(steadyNow(), [this](const std::string& node, SteadyTime since) {
    return connections_->master().lives(node, since);
  });
}

void MapMirror::startOver() {
  map_stamp_.reset();
  update_stamp_.reset();
  recent_.clear();
}

bool MapMirror::admits(const std::string& publisher) {
  if (mayBelongTo(publisher) || !ownerLives()) return true;
  refused_a_map_ = true;
  refuse(publisher);
  return false;
}

void MapMirror::own(const std::string& publisher, const std_msgs::Header& header, Way way) {
  if (!mayBelongTo(publisher)) replaced_ = true;
  if (publisher != owner_.name() || way != way_) startOver();
  owner_.hear(publisher, steadyNow());
  way_ = way;
  refused_a_map_ = false;
  lacks_changes_ = false;
  heard_frame_ = header.frame_id;
}

void MapMirror::handleMap(const nav_msgs::OccupancyGrid& msg, const std::string& publisher) {
  if (!rightFrame(msg.header.frame_id)) return;
  if (way_ == Way::kCompact && publisher == owner_.name()) {
    left_map_aside_ = true;
    return;
  }
  if (!admits(publisher)) return;
  std::string why;
  auto map = toOccupancyGrid(msg, &why);
  if (!map) return rejections_.add(why);
  const Time stamp = toTime(msg.header.stamp);
  // Messages of one connection arrive in order, so a stamp that goes back means that the clock was set back.
  const bool went_back = map_stamp_ && stamp < *map_stamp_;
  if (stamp == Time{} || went_back) startOver();
  own(publisher, msg.header, Way::kPlain);
  takeWhole(std::move(*map), stamp);
}

void MapMirror::takeWhole(OccupancyGrid map, Time stamp) {
  const bool comparable = map_stamp_.has_value();
  const bool same_geometry = ready() && map.geometry() == map_.geometry();
  map_stamp_ = stamp;
  // An update with the stamp of a map of another geometry belongs to the map before it.
  recent_.dropBefore(same_geometry ? stamp : stamp + Duration(1));
  // Updates newer than this map are no longer kept: the copy contains them, this map with the kept ones would not.
  if (comparable && same_geometry && !recent_.completeFrom(stamp)) return;
  const std::optional<Time> last = recent_.applyTo(map);
  replace(std::move(map));
  stamp_ = last.value_or(stamp);
}

void MapMirror::replace(OccupancyGrid map) {
  const GridGeometry& was = map_.geometry();
  const GridGeometry& is = map.geometry();
  if (ready() && was == is) {
    changed_.include(difference(map_, map));
  } else {
    if (ready() && (is.width < was.width || is.height < was.height)) {
      THROTTLED_WARN("map shrank from " << was.width << " x " << was.height << " to " << is.width << " x " << is.height
                                        << " cells: the smaller one replaces it");
    }
    changed_ = is.rect();
  }
  map_ = std::move(map);
}

void MapMirror::handleUpdate(const map_msgs::OccupancyGridUpdate& msg, const std::string& publisher) {
  if (!rightFrame(msg.header.frame_id)) return;
  if (!mayBelongTo(publisher)) return refuse(publisher);
  if (way_ == Way::kCompact) return;
  if (publisher != owner_.name()) startOver();
  owner_.hear(publisher, steadyNow());
  std::string why;
  const auto update = toGridUpdate(msg, &why);
  if (!update) return rejections_.add(why);
  const Time stamp = toTime(msg.header.stamp);
  remember(stamp, *update);
  if (!ready() || isOld(stamp)) return;
  if (!isInside(update->rect, map_)) return rejections_.add("update reaches beyond the map");
  copy(*update, map_);
  changed_.include(update->rect);
  stamp_ = stamp;
}

void MapMirror::handleChanges(const MapChanges& msg, const std::string& publisher) {
  if (!rightFrame(msg.header.frame_id)) return;
  const bool whole = msg.whole != 0;
  if (whole && !admits(publisher)) return;
  if (!whole && !mayBelongTo(publisher)) return refuse(publisher);
  std::string why;
  const auto changes = CheckedMapChanges::check(msg, &why);
  if (!changes) return rejections_.add(why);
  if (whole) {
    own(publisher, msg.header, Way::kCompact);
    replace(changes->whole());
  } else {
    if (way_ != Way::kCompact) return;  // its whole map has not come yet
    owner_.hear(publisher, steadyNow());
    if (msg.sequence != sequence_ + 1) lacks_changes_ = true;
    if (changes->geometry() != map_.geometry()) {
      lacks_changes_ = true;
      return rejections_.add("changes of a map of another size or place");
    }
    changed_.include(changes->applyTo(map_));
  }
  sequence_ = msg.sequence;
  stamp_ = toTime(msg.header.stamp);
}

void MapMirror::remember(Time stamp, const GridUpdate& update) {
  if (stamp == Time{}) return;
  if (update_stamp_ && stamp < *update_stamp_) startOver();
  update_stamp_ = stamp;
  if (!isOld(stamp)) recent_.add(stamp, update);
}

CellRect MapMirror::takeChanged() {
  askAgain();
  return std::exchange(changed_, CellRect{});
}

}  // namespace frontier_pilot
