#pragma once

#include <map>
#include <string>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// The nodes that have recently published a topic which only one node should publish. [FLT-1]
class HeardPublishers {
 public:
  /// `node` sent a message.
  void add(const std::string& node, SteadyTime now);
  /// The names of the nodes heard within the last three seconds, if there are several; otherwise empty.
  std::string severalNames(SteadyTime now) const;

 private:
  std::map<std::string, SteadyTime> last_;
};

}  // namespace frontier_pilot
