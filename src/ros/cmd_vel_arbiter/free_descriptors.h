#pragma once

#include <string>

namespace frontier_pilot {

/// Why a caller of a service of this process could not connect at the moment: it has hardly any file descriptor left,
/// or the whole computer has none. Empty if a caller could. [ARB-12]
std::string whyNoCallerCanConnect();

}  // namespace frontier_pilot
