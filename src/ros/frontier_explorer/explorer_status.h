#pragma once

#include <frontier_pilot/ExplorerStatus.h>

#include <string>

#include "frontier_pilot/exploration/explorer_types.h"

namespace frontier_pilot {

/// Without what bounds and ends the exploration.
ExplorerStatus toStatusMsg(const exploration::ExplorerProgress& progress, const std::string& frame, Time stamp);

}  // namespace frontier_pilot
