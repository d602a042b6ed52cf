#pragma once

#include <ros/node_handle.h>
#include <ros/service_client.h>

#include <mutex>
#include <optional>
#include <string>

#include "ros/common/threads/worker.h"

namespace frontier_pilot {

/// `path` for one robot of several: with its name at the end, or else each one's map would be saved over the others'.
/// The name is empty for a robot that is alone.
std::string pathOfRobot(const std::string& path, const std::string& robot);

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

}  // namespace frontier_pilot
