#pragma once

#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"

namespace frontier_pilot::logs {

/// A scan of a recorded drive, and what odometry said when it was taken (at `scan.stamp`).
struct LogRecord {
  Pose2 T_odom_base;
  LaserScan2 scan;
};

/// A recorded drive, in the order of the file.
struct ScanLog {
  std::vector<LogRecord> records;
  std::vector<std::string> notes;  ///< for people: what was passed over or had to be guessed
};

/// A log that cannot be read. `what()` names the file, the line and what is wrong with it.
class LogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class LogFormat {
  kCsv,     ///< our own, see `readCsvLog`
  kCarmen,  ///< see `readCarmenLog`
  kRosbag,  ///< needs ROS
};

/// What the file's first line looks like. Puts the stream back to where it was.
LogFormat formatOf(std::istream& file);

/// How a scanner sits on a robot, where a log does not say.
struct LogScanner {
  std::optional<Pose2> T_base_sensor;   ///< the format's own default if not given
  std::optional<double> range_max;      ///< a longer range is no return [m]; the format's own default if not given
  std::optional<double> field_of_view;  ///< [rad]; the format's own default if not given
};

/// Reads a CSV or CARMEN log. Throws a LogError where it is broken or holds no scan.
ScanLog readScanLog(std::istream& file, const std::string& name, const LogScanner& scanner = {});

}  // namespace frontier_pilot::logs
