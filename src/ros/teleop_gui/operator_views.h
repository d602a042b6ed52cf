#pragma once

#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/AvoiderStatus.h>
#include <frontier_pilot/ExplorerStatus.h>

#include <string>

#include "frontier_pilot/avoid/parameters.h"
#include "teleop/operator_state.h"

/// From the status messages to what an operator is shown.
namespace frontier_pilot {

/// `status_age` [s] is how long ago it came: the ages of silent sources have grown by it.
teleop::ArbiterView toView(const ArbiterStatus& msg, double status_age);
teleop::AvoiderView toView(const AvoiderStatus& msg, double status_age);
teleop::ExplorerView toView(const ExplorerStatus& msg, double status_age);
teleop::AvoiderSectors toSectors(const avoid::AvoiderParameters& parameters);

}  // namespace frontier_pilot
