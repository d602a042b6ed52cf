#include "ros/common/messages/map_mirror.h"

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include "frontier_pilot/core/bounds.h"
#include "robot_check/other_names.h"
#include "ros/common/clock.h"
#include "ros/common/maps/map_changes.h"
#include "ros/common/master/master_state.h"
#include "ros/common/names.h"
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

/// Without the simulator's picture of the world, which has the type of a map, but is not to be taken for one.
InputWatch::Topics mapsAmong(InputWatch::Topics topics) {
  const std::string world = std::string("/") + names::kWorld;
  const auto is_world = [&world](const auto& topic) { return boost::algorithm::ends_with(topic.name, world); };
  topics.erase(std::remove_if(topics.begin(), topics.end(), is_world), topics.end());
  return topics;
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

void MapMirror::subscribe(NodeConnections& connections, const std::string& frame, const std::string& robot, Need need) {
  frame_ = frame;
  topic_ = names::ofRobot(robot, names::kMap);
  updates_topic_ = names::ofRobot(robot, names::kMapUpdates);
  whole_name_ = connections.resolve(topic_);
  changes_topic_ = names::changesOf(whole_name_);
  connections_ = &connections;
  listenToChanges();
  listenToMap();
  connections.everySteady(ros::WallDuration(0.5), [this, &connections] { chooseTopics(connections.master()); });
  if (need == Need::kNeeded)
    connections.inputs().need([this](const InputWatch::Topics& topics) { return missing(topics); });
}

void MapMirror::listenToMap() {
  map_subscriber_.shutdown();
  updates_subscriber_.shutdown();
  map_subscriber_ = connections_->subscribeToEvents<nav_msgs::OccupancyGrid>(
      topic_, 1, [this](const auto& event) { handleMap(*event.getConstMessage(), event.getPublisherName()); });
  updates_subscriber_ = connections_->subscribeToEvents<map_msgs::OccupancyGridUpdate>(
      updates_topic_, 100,
      [this](const auto& event) { handleUpdate(*event.getConstMessage(), event.getPublisherName()); });
}

void MapMirror::listenToChanges() {
  changes_subscriber_.shutdown();
  changes_subscriber_ = connections_->subscribeToEvents<MapChanges>(changes_topic_, 100, [this](const auto& event) {
    handleChanges(*event.getConstMessage(), event.getPublisherName());
  });
}

bool MapMirror::isOfferedPlain(const MasterWatch& master) const {
  const std::vector<std::string> compact = master.publishersOf(changes_topic_);
  const std::vector<std::string> all = master.publishersOf(whole_name_);
  return std::any_of(all.begin(), all.end(), [&](const std::string& node) {
    return std::find(compact.begin(), compact.end(), node) == compact.end();
  });
}

void MapMirror::chooseTopics(const MasterWatch& master) {
  constexpr Duration kBetweenQuestions = std::chrono::seconds(5);
  constexpr Duration kRecent = std::chrono::seconds(2);
  if (changes_subscriber_.getNumPublishers() == 0 && !isAsking()) way_ = Way::kPlain;
  const bool wants_map = way_ == Way::kPlain || isOfferedPlain(master);
  const bool asks = way_ == Way::kCompact && lacks_changes_ && steadyNow() - asked_ > kBetweenQuestions;
  const bool listens = map_subscriber_;
  if (wants_map == listens && !asks) return;
  // Without a master, each of these would wait for it. One that hangs is not asked: that takes long.
  if (steadyNow() - master.lastAnswer() > kRecent || !askMaster()) return;
  if (asks) {
    asked_ = steadyNow();
    listenToChanges();
  }
  if (wants_map && !listens) listenToMap();
  if (wants_map || !listens) return;
  map_subscriber_.shutdown();
  updates_subscriber_.shutdown();
}

bool MapMirror::published() const {
  return map_subscriber_.getNumPublishers() > 0 || changes_subscriber_.getNumPublishers() > 0 || isAsking();
}

bool MapMirror::isAsking() const {
  constexpr Duration kConnecting = std::chrono::seconds(2);
  return lacks_changes_ && steadyNow() - asked_ < kConnecting;
}

std::string MapMirror::missing(const InputWatch::Topics& topics) const {
  if (!published())
    return robot_check::sayMissingTopic(mapsAmong(topics), whole_name_, "nav_msgs/OccupancyGrid", topic_);
  return ready() ? "" : whole_name_ + " is published, but no map has arrived yet";
}

bool MapMirror::rightFrame(const std::string& frame) {
  const bool right = frame_.empty() || isSameFrame(frame, frame_);
  if (!right) rejections_.add("in frame '" + frame + "', not '" + frame_ + "'");
  return right;
}

void MapMirror::refuse(const std::string& publisher) {
  rejections_.add("from " + publisher + ", while " + publisher_ + " publishes the map");
}

bool MapMirror::ownerLives() {
  constexpr Duration kSilence = std::chrono::seconds(5);
  if (steadyNow() - owner_heard_ < kSilence) return true;
  if (!nodeLives(publisher_)) return false;
  owner_heard_ = steadyNow();
  return true;
}

void MapMirror::startOver() {
  map_stamp_.reset();
  update_stamp_.reset();
  recent_.clear();
}

bool MapMirror::admits(const std::string& publisher, Way way) {
  if (mayBelongTo(publisher)) return true;
  const std::uint32_t plain = map_subscriber_.getNumPublishers();
  const std::uint32_t compact = changes_subscriber_.getNumPublishers();
  // The owner may still be connected by the topics of the other kind alone.
  const bool by_others = way != way_ && (way_ == Way::kPlain ? plain : compact) > 0;
  if ((std::max(plain, compact) <= 1 && !by_others) || !ownerLives()) return true;
  refused_a_map_ = true;
  refuse(publisher);
  return false;
}

void MapMirror::own(const std::string& publisher, const std_msgs::Header& header, Way way) {
  if (publisher != publisher_ || way != way_) startOver();
  publisher_ = publisher;
  way_ = way;
  owner_heard_ = steadyNow();
  refused_a_map_ = false;
  lacks_changes_ = false;
  heard_frame_ = header.frame_id;
}

void MapMirror::handleMap(const nav_msgs::OccupancyGrid& msg, const std::string& publisher) {
  if (!rightFrame(msg.header.frame_id)) return;
  if (way_ == Way::kCompact && publisher == publisher_) return;
  if (!admits(publisher, Way::kPlain)) return;
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
  if (publisher != publisher_) startOver();
  publisher_ = publisher;
  owner_heard_ = steadyNow();
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
  if (whole && !admits(publisher, Way::kCompact)) return;
  if (!whole && !mayBelongTo(publisher)) return refuse(publisher);
  std::string why;
  const auto changes = CheckedMapChanges::check(msg, &why);
  if (!changes) return rejections_.add(why);
  if (whole) {
    own(publisher, msg.header, Way::kCompact);
    replace(changes->whole());
  } else {
    if (way_ != Way::kCompact) return;  // its whole map has not come yet
    owner_heard_ = steadyNow();
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

void MapMirror::askAgain() {
  if (!refused_a_map_ || ownerLives()) return;
  if (!askMaster()) return;  // without a master, a new subscription would wait for it and the old one would be lost
  refused_a_map_ = false;
  way_ = Way::kPlain;
  listenToChanges();
  listenToMap();
}

CellRect MapMirror::takeChanged() {
  askAgain();
  return std::exchange(changed_, CellRect{});
}

}  // namespace frontier_pilot
