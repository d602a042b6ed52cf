// Which topics a MapMirror listens to, and who publishes them.
#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <vector>

#include "robot_check/other_names.h"
#include "ros/common/clock.h"
#include "ros/common/master/master_state.h"
#include "ros/common/messages/map_mirror.h"
#include "ros/common/names.h"

namespace frontier_pilot {
namespace {

/// Without the simulator's picture of the world, which has the type of a map, but is not to be taken for one.
InputWatch::Topics mapsAmong(InputWatch::Topics topics) {
  const std::string world = std::string("/") + names::kWorld;
  const auto is_world = [&world](const auto& topic) { return boost::algorithm::ends_with(topic.name, world); };
  topics.erase(std::remove_if(topics.begin(), topics.end(), is_world), topics.end());
  return topics;
}

}  // namespace

void MapMirror::subscribe(NodeConnections& connections, const std::string& frame, const std::string& robot, Need need) {
  frame_ = frame;
  topic_ = names::ofRobot(robot, names::kMap);
  updates_topic_ = names::ofRobot(robot, names::kMapUpdates);
  whole_name_ = connections.resolve(topic_);
  changes_topic_ = names::changesOf(whole_name_);
  connections_ = &connections;
  connections.master().watchPublishers(whole_name_);
  connections.master().watchPublishers(changes_topic_);
  listenToChanges();
  listenToMap();
  connections.everySteady(ros::WallDuration(0.5), [this, &connections] { chooseTopics(connections.master()); });
  if (need == Need::kNeeded)
    connections.inputs().need([this](const InputWatch::Topics& topics) { return missing(topics); });
}

void MapMirror::listenToMap() {
  left_map_aside_ = false;
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

bool MapMirror::masterAnswers() const {
  constexpr Duration kRecent = std::chrono::seconds(2);
  return steadyNow() - connections_->master().lastAnswer() <= kRecent && askMaster();
}

void MapMirror::chooseTopics(const MasterWatch& master) {
  constexpr Duration kBetweenQuestions = std::chrono::seconds(5);
  if (changes_subscriber_.getNumPublishers() == 0 && !isAsking()) way_ = Way::kPlain;
  const bool wants_map = way_ == Way::kPlain || isOfferedPlain(master);
  const bool asks = way_ == Way::kCompact && lacks_changes_ && steadyNow() - asked_ > kBetweenQuestions;
  // A map that was left aside is sent once only; without `map_changes`, it is the one that is needed.
  const bool lacks_map = way_ == Way::kPlain && left_map_aside_;
  const bool listens = map_subscriber_ && !lacks_map;
  if (wants_map == listens && !asks) return;
  if (!masterAnswers()) return;  // each of these would wait for it
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
  if (connections_ == nullptr) return false;
  const MasterWatch& master = connections_->master();
  return master.mayReceive(map_subscriber_) || master.mayReceive(changes_subscriber_) || isAsking();
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

void MapMirror::askAgain() {
  if (!refused_a_map_ || ownerLives()) return;
  if (!masterAnswers()) return;  // without a master, a new subscription would wait for it and the old one would be lost
  refused_a_map_ = false;
  way_ = Way::kPlain;
  listenToChanges();
  listenToMap();
}

}  // namespace frontier_pilot
