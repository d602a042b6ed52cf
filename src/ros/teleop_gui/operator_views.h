#pragma once

#include <dynamic_reconfigure/Config.h>
#include <frontier_pilot/ArbiterStatus.h>
#include <frontier_pilot/AvoiderStatus.h>
#include <frontier_pilot/ExplorerStatus.h>
#include <frontier_pilot/NavigatorProgress.h>
#include <ros/serialization.h>

#include <optional>

#include "frontier_pilot/avoid/parameters.h"
#include "frontier_pilot/core/bounds.h"
#include "ros/common/messages/mailbox.h"
#include "ros/common/throttled_log.h"
#include "teleop/operator_state.h"

/// Converts status messages to what the operator is shown.
namespace frontier_pilot {

/// `status_age` [s] is how long ago the status arrived; it is added to the ages of silent sources.
teleop::ArbiterView toView(const ArbiterStatus& msg, double status_age);
teleop::AvoiderView toView(const AvoiderStatus& msg, double status_age);
teleop::ExplorerView toView(const ExplorerStatus& msg, double status_age);
teleop::NavigationView toView(const NavigatorProgress& msg, double status_age);
/// The avoider's parameters with the distances that it has told on `parameter_updates`; those of before if the message
/// holds what they cannot be.
avoid::AvoiderParameters tuned(const avoid::AvoiderParameters& before, const dynamic_reconfigure::Config& msg);
teleop::AvoiderSectors toSectors(const avoid::AvoiderParameters& parameters);

/// Fills `view` from the latest message, if there is one.
template <class View, class Msg>
void show(const Latest<Msg>& latest, SteadyTime now, std::optional<View>& view) {
  if (latest.has()) view = toView(*latest.get(), toSeconds(*latest.age(now)));
}

/// Whether a message is small enough to be shown in the window. [FLT-1]
template <class Msg>
bool isShown(const Msg& msg) {
  const bool shown = ros::serialization::serializationLength(msg) <= bounds::kMostStatus;
  if (!shown) THROTTLED_WARN("a status of more than " << bounds::kMostStatus << " bytes is not shown");
  return shown;
}

}  // namespace frontier_pilot
