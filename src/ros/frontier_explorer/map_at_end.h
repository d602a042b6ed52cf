#pragma once

#include <ros/node_handle.h>
#include <ros/service_client.h>

#include <mutex>
#include <optional>
#include <string>

#include "frontier_pilot/core/time.h"
#include "ros/common/threads/worker.h"

namespace frontier_pilot {

/// Asks the mapper for a saved map, on a thread of its own: saving takes seconds, and a mapper that hangs never
/// answers. The destructor ends a call that is waiting. [EXP-10]
class SaveMapCaller {
 public:
  /// How it ended.
  struct End {
    bool success = false;
    std::string message;  ///< of the mapper, or why there is none
  };

  explicit SaveMapCaller(const ros::NodeHandle& node) : node_(node) {}
  ~SaveMapCaller();
  SaveMapCaller(const SaveMapCaller&) = delete;
  SaveMapCaller& operator=(const SaveMapCaller&) = delete;

  /// `path` as in SaveMap.srv. While an earlier call is still waiting, the map is saved after it: more has been
  /// explored by then.
  void save(const std::string& path);
  /// How the call ended, once.
  std::optional<End> take();

 private:
  End call(const std::string& path);

  ros::NodeHandle node_;
  std::mutex mutex_;  ///< guards the two that follow
  ros::ServiceClient client_;
  bool ending_ = false;
  Worker<End> worker_;  ///< the last member: its thread uses the others
};

/// The map that is saved whenever the exploration has ended. As long as nothing else is explored a failure is followed
/// by another attempt, because the mapper may have died and be back soon. [EXP-10]
class MapAtEnd {
 public:
  /// `path` as in SaveMap.srv, empty if no map is to be saved; `robot` is the name of one of several, empty if it is
  /// alone.
  MapAtEnd(const ros::NodeHandle& node, const std::string& path, const std::string& robot);

  /// `ended`: the exploration has ended since the last call; `done`: it is over now. Returns whether there is something
  /// new to tell of a call that has ended.
  bool update(bool ended, bool done, SteadyTime now);
  /// Where the map is saved; empty: nowhere.
  const std::string& path() const { return path_; }
  /// How that goes, in words; empty before the first end.
  const std::string& outcome() const { return outcome_; }
  /// Whether the last attempt has failed.
  bool isLost() const { return lost_; }

 private:
  SaveMapCaller caller_;
  std::string path_;
  std::string outcome_;
  bool lost_ = false;
  std::optional<SteadyTime> again_;  ///< when it is tried again
};

}  // namespace frontier_pilot
