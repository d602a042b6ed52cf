#pragma once

#include <map>
#include <string>
#include <vector>

#include "ros/common/master/master_state.h"

namespace frontier_pilot {

/// Notices at the master that an arbiter has its service `emergency_stop` again, or for the first time, after another
/// node or nobody had it. A connection that was made meanwhile may lead to that other node, which can live on and
/// answer although its service is registered no longer. A connection to the arbiter itself, made before another node
/// took the service over, is left alone until then. [MUL-4]
class RegainedServices {
 public:
  /// The resolved names of the services that arbiters have regained since the last call.
  std::vector<std::string> take(const NodesByName& publishers, const NodesByName& providers);

 private:
  bool has_looked_ = false;
  std::map<std::string, std::string> provider_;  ///< by service, at the last call; empty: nobody
};

}  // namespace frontier_pilot
