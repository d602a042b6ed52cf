#pragma once

#include <map>
#include <string>
#include <vector>

#include "frontier_pilot/core/time.h"
#include "ros/common/master/master_state.h"
#include "ros/common/master/registration.h"

namespace frontier_pilot {

/// Decides when a lost connection is to be made again: once it has been missing for two seconds, because a connection
/// takes its time to be made, and then after pauses that double from ten seconds to five minutes, because it may be
/// impossible (a publisher of another type), and each attempt leaves an error in the log.
class ReconnectTimes {
 public:
  /// Of `lost`, the names of all connections that are missing, those that are to be made now. A connection that is not
  /// in it any more begins anew when it is lost again.
  std::vector<std::string> due(const std::vector<std::string>& lost, SteadyTime now);

 private:
  struct Attempt {
    SteadyTime next;
    Duration pause;
  };

  std::map<std::string, Attempt> attempts_;  ///< by connection
};

/// Connects this node again to publishers that it has lost. A subscriber connects when the master tells it who
/// publishes its topic; roscpp never asks again, so that a message of the master that is lost, or forged by a node that
/// names no publisher or another one, leaves the subscriber without its publisher until one of the two is restarted.
/// [FLT-1]
class LostConnections {
 public:
  /// Connects to each living publisher that `state` has for a topic of `subscribed`, and that has not been in
  /// `connected`, those that this node is connected to, for two seconds. To be called about once a second, always on
  /// the same thread.
  void mend(const MasterState& state, const std::vector<std::string>& subscribed, const UrisByTopic& connected);

 private:
  /// The publishers, other than this node itself, that it should be connected to and is not, by topic.
  NodesByName findLost(const MasterState& state, const std::vector<std::string>& subscribed,
                       const UrisByTopic& connected);

  ReconnectTimes times_;
  std::map<std::string, std::string> uris_;  ///< by node: its address in the last look
};

}  // namespace frontier_pilot
