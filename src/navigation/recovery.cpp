#include "frontier_pilot/navigation/recovery.h"

namespace frontier_pilot::navigation {

std::vector<RecoveryRung> clearingLadder() { return {{"clearing the local costmap", true, {}}}; }

}  // namespace frontier_pilot::navigation
