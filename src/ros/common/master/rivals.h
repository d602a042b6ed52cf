#pragma once

#include <map>
#include <string>
#include <vector>

#include "ros/common/master/master_state.h"

namespace frontier_pilot {

/// What belongs to this node alone, by resolved names.
struct Claims {
  std::vector<std::string> services;
  std::vector<std::vector<std::string>> topics;  ///< whoever publishes all of one of these lists is a rival
};

/// The other living node for each service or topic, the first of its list, of `claims`; nothing for what has no rival.
/// Costs a call to each node that might be one. [ARB-12]
std::map<std::string, std::string> findRivals(const Claims& claims, const MasterState& state);

}  // namespace frontier_pilot
