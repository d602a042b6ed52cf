#pragma once

#include <istream>
#include <string>

#include "frontier_pilot/logs/scan_log.h"

namespace frontier_pilot::logs {

/// Reads lines `stamp [s], odom x [m], odom y [m], odom yaw [rad], range [m], range, ...`. The ranges run from right to
/// left over the field of view, its ends included; 0 is an invalid reading. Empty lines and lines that begin with # are
/// skipped. Defaults: a field of view of 180 degrees, ranges up to 80 m, the scanner 0.78 m ahead of the base.
/// Throws a LogError naming `name` and the line.
ScanLog readCsvLog(std::istream& file, const std::string& name, const LogScanner& scanner = {});

}  // namespace frontier_pilot::logs
