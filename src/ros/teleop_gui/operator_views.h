#pragma once

#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/AvoiderStatus.h>
#include <frontier_pilot/ExplorerStatus.h>
#include <frontier_pilot/NavigatorProgress.h>

#include <string>

#include "frontier_pilot/avoid/parameters.h"
#include "teleop/operator_state.h"

/// Converts status messages to what the operator is shown.
namespace frontier_pilot {

/// `status_age` [s] is how long ago the status arrived; it is added to the ages of silent sources.
teleop::ArbiterView toView(const ArbiterStatus& msg, double status_age);
teleop::AvoiderView toView(const AvoiderStatus& msg, double status_age);
teleop::ExplorerView toView(const ExplorerStatus& msg, double status_age);
teleop::NavigationView toView(const NavigatorProgress& msg, double status_age);
teleop::AvoiderSectors toSectors(const avoid::AvoiderParameters& parameters);

}  // namespace frontier_pilot
