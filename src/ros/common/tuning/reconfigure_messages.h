#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>

#include <string>
#include <vector>

#include "ros/common/tuning/tunable_fields.h"

namespace frontier_pilot {

/// The values of `fields` as dynamic_reconfigure sends them, in one group.
dynamic_reconfigure::Config toConfigMsg(const std::vector<TunableField>& fields);

/// What dynamic_reconfigure's clients have to know of the fields: types, bounds, defaults and meaning. A number without
/// a bound has the greatest that its type can hold. The message has no sign for a bound that is itself excluded.
dynamic_reconfigure::ConfigDescription toDescriptionMsg(const std::vector<TunableField>& defaults);

/// The changes that `msg` asks for, nested as in YAML. Values of a wrong type and unknown names are `problems`.
ParameterMap toChanges(const dynamic_reconfigure::Config& msg, const std::vector<TunableField>& fields,
                       Problems& problems);

}  // namespace frontier_pilot
