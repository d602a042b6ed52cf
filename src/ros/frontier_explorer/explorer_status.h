#pragma once

#include <frontier_pilot/ExplorerStatus.h>

#include <string>

#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot {

/// `map_saved`: how save_map_at_end went.
ExplorerStatus toStatusMsg(const exploration::ExplorerProgress& progress, const exploration::ExplorationBounds& bounds,
                           const std::string& map_saved, const std::string& frame, Time stamp);

}  // namespace frontier_pilot
