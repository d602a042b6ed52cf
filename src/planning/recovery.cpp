#include "frontier_pilot/planning/recovery.h"

namespace frontier_pilot {

std::vector<RecoveryRung> clearingLadder() { return {{"clearing the local costmap", true, {}}}; }

}  // namespace frontier_pilot
