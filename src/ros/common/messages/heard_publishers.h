#pragma once

#include <map>
#include <string>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Who has published a topic of late, for topics that one node alone should publish. [FLT-1]
class HeardPublishers {
 public:
  /// `node` sent a message.
  void add(const std::string& node, SteadyTime now);
  /// The names of those that were heard within the last seconds, if they are several; otherwise empty.
  std::string severalNames(SteadyTime now) const;

 private:
  std::map<std::string, SteadyTime> last_;
};

}  // namespace frontier_pilot
