#pragma once

#include <frontier_pilot/MapChanges.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/time.h"
#include "ros/common/diagnostics.h"
#include "ros/common/maps/map_owner.h"
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

/// A copy of `map` that knows which cells changed since they were last taken. It is kept up to date by `map_changes` if
/// the publisher of the map offers that, in few bytes, and otherwise by `map` and `map_updates`.
///
/// All three are listened to until a whole map has come by `map_changes`. From then on the other two are not subscribed
/// to, as long as that topic has a publisher and no other node offers `map` alone; what still comes of them from the
/// owner of the map is left aside. One connection brings all of `map_changes` in order, whatever the stamps. If one of
/// its messages is lost, the map is asked for again: a publisher sends it whole to a new subscriber. [MUL-1]
///
/// `map` and `map_updates` have a connection each, so a large map may arrive after updates that are newer than it. Maps
/// and updates are ordered by their stamps: a map contains every update older than itself, and recent updates with its
/// stamp or a later one are applied to it again. Stamps are not compared across a jump of the clock (recognised when
/// the stamps of either topic go back) nor between publishers. A map or update without a stamp is applied as it comes.
///
/// The first node that sends a map owns it: while that node lives, maps and updates of any other node are refused,
/// whichever topics they come by, and counted by that node's name; also while the owner withdraws its topics, as a
/// mapper does beside another one. A map and its updates come from one node. Once the owner of a map has died, a map
/// that was refused is asked for again. [FLT-1]
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
  void handleChanges(const MapChanges& msg, const std::string& publisher = {});

  /// Whether the map has a publisher now. One that was killed counts as gone within about a second.
  bool published() const;
  /// Whether a message was lost since the last whole map of `map_changes`.
  bool lacksChanges() const { return lacks_changes_; }
  /// Whether a map has been received.
  bool ready() const { return !map_.empty(); }
  const OccupancyGrid& map() const { return map_; }
  /// The frame of the map; empty before the first one.
  const std::string& frame() const { return heard_frame_; }
  /// The stamp of the last map or update in the copy.
  Time stamp() const { return stamp_; }
  /// The cells that may have changed since the last call; all cells if the geometry has changed.
  CellRect takeChanged();
  /// Whether another node's map has replaced the one of before since the last call: a place on that one may be anywhere
  /// on this one. The node that had the map may be restarted; its map is taken for the same. [MAP-5] [FLT-2]
  bool takeReplaced() { return std::exchange(replaced_, false); }
  const Rejections& rejections() const { return rejections_; }
  /// What is missing, in words; empty if there is a map and its publisher.
  std::string missing(const InputWatch::Topics& topics) const;

 private:
  /// By which topics a map comes: `map` and `map_updates`, or `map_changes`.
  enum class Way { kPlain, kCompact };

  bool rightFrame(const std::string& frame);
  /// Before the first map there is no owner.
  bool mayBelongTo(const std::string& publisher) const { return !ready() || publisher == owner_.name(); }
  void refuse(const std::string& publisher);
  /// Whether a whole map of `publisher` is taken; if not, it is refused.
  bool admits(const std::string& publisher);
  /// A map of `publisher` is taken, which owns it from now on.
  void own(const std::string& publisher, const std_msgs::Header& header, Way way);
  /// Whether a node publishes `map` and not `map_changes`.
  bool isOfferedPlain(const MasterWatch& master) const;
  /// Whether the map was asked for because changes were lost, so recently that its publisher may not be connected yet.
  bool isAsking() const;
  /// Whether the master answers now. One that hangs is not asked: that takes long.
  bool masterAnswers() const;
  /// Subscribes to those topics that are needed now.
  void chooseTopics(const MasterWatch& master);
  void listenToMap();
  void listenToChanges();
  /// Whether the owner still lives. Nothing is waited for: a silent one is looked for on the thread of the MasterWatch.
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

  std::string topic_, updates_topic_, changes_topic_;
  std::string whole_name_;  ///< of `topic_`, with the namespace and the remappings of the node's handle
  std::string frame_, heard_frame_;
  OccupancyGrid map_;
  CellRect changed_;
  bool replaced_ = false;  ///< by the map of another node, since that was last asked
  Time stamp_{};
  Way way_ = Way::kPlain;             ///< by which the map came
  MapOwner owner_;                    ///< of the map; before the first one, of the updates so far
  std::optional<Time> map_stamp_;     ///< of the last map; none after `startOver`
  std::optional<Time> update_stamp_;  ///< of the last update that had one
  RecentUpdates recent_;
  std::uint32_t sequence_ = 0;  ///< of the last message of `map_changes`
  bool lacks_changes_ = false;
  SteadyTime asked_{};  ///< when the map was last asked for because changes were lost
  Rejections rejections_{"map message"};
  NodeConnections* connections_ = nullptr;  ///< null before `subscribe`
  ros::Subscriber map_subscriber_, updates_subscriber_, changes_subscriber_;
  bool refused_a_map_ = false;   ///< since the map was last asked for, or last came from its owner
  bool left_map_aside_ = false;  ///< since `map` was last subscribed to: its owner also sent `map_changes`
};

}  // namespace frontier_pilot
