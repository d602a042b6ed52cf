#pragma once

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>

#include <cstddef>
#include <deque>
#include <optional>
#include <string>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/time.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/node_connections.h"

namespace frontier_pilot {

/// The updates of a map that came last, as many as are bounded by their number and their cells. Their stamps ascend.
class RecentUpdates {
 public:
  void add(Time stamp, GridUpdate update);
  void clear() { *this = {}; }
  /// Forgets what is older than `stamp`.
  void dropBefore(Time stamp);
  /// Whether none with this stamp or a later one has been forgotten for want of room.
  bool completeFrom(Time stamp) const { return !lost_ || *lost_ < stamp; }
  /// Copies those that lie inside of `map` into it, and gives the stamp of the last one.
  std::optional<Time> applyTo(OccupancyGrid& map) const;

 private:
  struct Stamped {
    Time stamp;
    GridUpdate update;
  };
  std::deque<Stamped> updates_;
  std::size_t cells_ = 0;     ///< of all of them
  std::optional<Time> lost_;  ///< stamp of the last one that was forgotten for want of room
};

/// A copy of `map`, kept up to date by `map_updates`, that knows which cells changed since they were last taken.
///
/// The two topics come over a connection each, so that a large map may arrive after updates that are newer than it.
/// They are ordered by their stamps: a map holds every update that is older than itself, and recent updates with its
/// stamp or a later one are applied to it again. Stamps are not compared across a jump of the clock (either topic's
/// stamps go back) nor between publishers, and a map or an update without a stamp is taken as it comes.
///
/// The first node that sends a map owns it: while it lives, maps and updates of any other node are refused, and counted
/// by that node's name. A map and its updates come from one node. [FLT-1]
///
/// What is malformed is counted and warned of, and leaves the copy as it was. A smaller map replaces a larger one (a
/// mapper that started over), which is said in the log.
class MapMirror {
 public:
  /// Begins to listen. Maps in another frame than `frame` are refused.
  void subscribe(NodeConnections& connections, const std::string& frame);

  /// `publisher` is the node that sent it.
  void handleMap(const nav_msgs::OccupancyGrid& msg, const std::string& publisher = {});
  void handleUpdate(const map_msgs::OccupancyGridUpdate& msg, const std::string& publisher = {});

  /// Whether somebody publishes the map now.
  bool published() const { return map_subscriber_.getNumPublishers() > 0; }
  /// Whether a map has come yet.
  bool ready() const { return !map_.empty(); }
  const OccupancyGrid& map() const { return map_; }
  /// The stamp of the last map or update that is in the copy.
  Time stamp() const { return stamp_; }
  /// The cells that may differ from what was there at the last call; all of them when the geometry is another one.
  CellRect takeChanged();
  const Rejections& rejections() const { return rejections_; }

 private:
  bool rightFrame(const std::string& frame);
  /// Before the first map nobody owns it.
  bool mayBelongTo(const std::string& publisher) const { return !ready() || publisher == publisher_; }
  void refuse(const std::string& publisher);
  /// Whether the owner is there still, although another node publishes: asked of it where it was silent for long.
  bool ownerLives();
  /// Forgets the stamps: nothing that comes from now on is compared with what came before.
  void startOver();
  void takeWhole(OccupancyGrid map, Time stamp);
  /// Whether the copy is newer than the update already.
  bool isOld(Time stamp) const { return map_stamp_ && stamp != Time{} && stamp < *map_stamp_; }
  void remember(Time stamp, const GridUpdate& update);
  void replace(OccupancyGrid map);

  std::string frame_;
  OccupancyGrid map_;
  CellRect changed_;
  Time stamp_{};
  std::string publisher_;             ///< the owner of the map; before the first one, of the updates so far
  SteadyTime owner_heard_{};          ///< when it last sent something, or was seen to live
  std::optional<Time> map_stamp_;     ///< of the last map, unless nothing is compared with it
  std::optional<Time> update_stamp_;  ///< of the last update that had one
  RecentUpdates recent_;
  Rejections rejections_{"map message"};
  ros::Subscriber map_subscriber_;
};

}  // namespace frontier_pilot
