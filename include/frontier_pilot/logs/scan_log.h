#pragma once

#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"

namespace frontier_pilot::logs {

/// A scan of a recorded drive, and the odometry pose at its stamp.
struct LogRecord {
  Pose2 T_odom_base;
  LaserScan2 scan;
};

/// A recorded drive, in the order of the file.
struct ScanLog {
  std::vector<LogRecord> records;
  std::vector<std::string> notes;  ///< in words: what was skipped or had to be assumed
};

/// A log that cannot be read. `what()` names the file, the line and what is wrong with it.
class LogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class LogFormat {
  kCsv,     ///< the format of this project, see `readCsvLog`
  kCarmen,  ///< see `readCarmenLog`
  kRosbag,  ///< needs ROS
};

/// The format, judged by the first line that is neither empty nor a comment. Restores the position in the stream.
LogFormat formatOf(std::istream& file);

/// Properties of the scanner, for logs that do not record them.
struct LogScanner {
  std::optional<Pose2> T_base_sensor;   ///< the format's own default if not given
  std::optional<double> range_max;      ///< longer ranges mean no return [m]; the format's own default if not given
  std::optional<double> field_of_view;  ///< [rad]; the format's own default if not given
};

/// Lowers `range_max` where the log's greatest range marks beams without a return: a value that occurs at least 20
/// times and ten times as often as the next smaller one is a limit of the scanner, not a wall. Adds a note then. Does
/// nothing if the log has infinite ranges or some beyond `range_max`, which mark such beams already.
void recogniseMissingReturns(ScanLog& log);

/// Throws a LogError if a scan's stamp is more than ten seconds before that of an earlier scan, as where two logs
/// follow one another in one file, or a simulated clock was set back: one map would be made of two drives. In real logs
/// the stamps of some scans go back by up to a second. Throws also where several scans all have one stamp.
void requireOneDrive(const ScanLog& log, const std::string& name);

/// Reads a CSV or CARMEN log. Throws a LogError where it is broken or holds no scan.
ScanLog readScanLog(std::istream& file, const std::string& name, const LogScanner& scanner = {});

}  // namespace frontier_pilot::logs
