#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot {

/// Converts a parameter to the core's type. Types without a counterpart (dates, binary data) become the empty
/// alternative, which no field accepts. Throws std::length_error if there are more values, or deeper ones, than a YAML
/// file may have. [FLT-1]
ParameterValue toParameterValue(XmlRpc::XmlRpcValue& value);

}  // namespace frontier_pilot
