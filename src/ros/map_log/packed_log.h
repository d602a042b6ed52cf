#pragma once

#include <string>
#include <string_view>

#include "frontier_pilot/logs/scan_log.h"

namespace frontier_pilot {

/// A log as bytes, for the way from a child process to its parent; no other program ever reads them.
std::string packLog(const logs::ScanLog& log);

/// The log that `packLog` has written. Throws std::length_error if it has not: bytes are missing or left over, or there
/// is no scan. [FLT-1]
logs::ScanLog unpackLog(std::string_view bytes);

}  // namespace frontier_pilot
