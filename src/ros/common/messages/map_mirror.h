#pragma once

#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/time.h"
#include "ros/common/diagnostics.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/node_connections.h"

namespace frontier_pilot {

/// The most recent updates of a map, limited in number and in total cells, in the order of their stamps.
class RecentUpdates {
 public:
  void add(Time stamp, GridUpdate update);
  void clear() { *this = {}; }
  /// Drops updates older than `stamp`.
  void dropBefore(Time stamp);
  /// Whether no update with this stamp or a later one was dropped because of the limits.
  bool completeFrom(Time stamp) const { return !lost_ || *lost_ < stamp; }
  /// Applies those that lie inside of `map` to it, and returns the stamp of the last one applied.
  std::optional<Time> applyTo(OccupancyGrid& map) const;

 private:
  struct Stamped {
    Time stamp;
    GridUpdate update;
  };
  std::deque<Stamped> updates_;
  std::size_t cells_ = 0;     ///< of all kept updates together
  std::optional<Time> lost_;  ///< stamp of the last update that was dropped because of the limits
};

/// A copy of `map`, kept up to date by `map_updates`, that knows which cells changed since they were last taken.
///
/// The two topics have a connection each, so a large map may arrive after updates that are newer than it. Maps and
/// updates are ordered by their stamps: a map contains every update older than itself, and recent updates with its
/// stamp or a later one are applied to it again. Stamps are not compared across a jump of the clock (recognised when
/// the stamps of either topic go back) nor between publishers. A map or update without a stamp is applied as it comes.
///
/// The first node that sends a map owns it: while that node lives, maps and updates of any other node are refused, and
/// counted by that node's name. A map and its updates come from one node. Once the owner of a map has died, a map that
/// was refused is asked for again. [FLT-1]
///
/// Malformed messages are counted with a warning and leave the copy as it was. A smaller map (of a mapper that started
/// over) replaces a larger one, with a warning in the log.
class MapMirror {
 public:
  /// Begins to listen to the topics in the namespace `robot`, by default the node's own. Maps in another frame than
  /// `frame` are refused, unless that is empty. The node waits for a map if it is `need`ed.
  void subscribe(NodeConnections& connections, const std::string& frame, const std::string& robot = {},
                 Need need = Need::kNeeded);

  /// `publisher` is the name of the node that sent the message.
  void handleMap(const nav_msgs::OccupancyGrid& msg, const std::string& publisher = {});
  void handleUpdate(const map_msgs::OccupancyGridUpdate& msg, const std::string& publisher = {});

  /// Whether the topic has a publisher now.
  bool published() const { return map_subscriber_.getNumPublishers() > 0; }
  /// Whether a map has been received.
  bool ready() const { return !map_.empty(); }
  const OccupancyGrid& map() const { return map_; }
  /// The frame of the map; empty before the first one.
  const std::string& frame() const { return heard_frame_; }
  /// The stamp of the last map or update in the copy.
  Time stamp() const { return stamp_; }
  /// The cells that may have changed since the last call; all cells if the geometry has changed.
  CellRect takeChanged();
  const Rejections& rejections() const { return rejections_; }

 private:
  /// What is missing, in words; empty if there is a map and its publisher.
  std::string missing(const InputWatch::Topics& topics) const;
  bool rightFrame(const std::string& frame);
  /// Before the first map there is no owner.
  bool mayBelongTo(const std::string& publisher) const { return !ready() || publisher == publisher_; }
  void refuse(const std::string& publisher);
  /// Whether the owner still lives. If it has been silent for five seconds, its XML-RPC port is tried.
  bool ownerLives();
  /// Subscribes anew if a map was refused whose rival has died since: publishers send their map to a new subscriber.
  void askAgain();
  /// Forgets the stamps: later messages are not compared with earlier ones.
  void startOver();
  void takeWhole(OccupancyGrid map, Time stamp);
  /// Whether the update is older than the last map.
  bool isOld(Time stamp) const { return map_stamp_ && stamp != Time{} && stamp < *map_stamp_; }
  void remember(Time stamp, const GridUpdate& update);
  void replace(OccupancyGrid map);

  std::string topic_;
  std::string frame_, heard_frame_;
  OccupancyGrid map_;
  CellRect changed_;
  Time stamp_{};
  std::string publisher_;             ///< the owner of the map; before the first one, of the updates so far
  SteadyTime owner_heard_{};          ///< when the owner last sent a message, or was found alive
  std::optional<Time> map_stamp_;     ///< of the last map; none after `startOver`
  std::optional<Time> update_stamp_;  ///< of the last update that had one
  RecentUpdates recent_;
  Rejections rejections_{"map message"};
  ros::Subscriber map_subscriber_;
  std::function<void()> listen_;  ///< subscribes to the map, anew if need be
  bool refused_a_map_ = false;    ///< since the map was last asked for, or last came from its owner
};

}  // namespace frontier_pilot
