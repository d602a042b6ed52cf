#include "frontier_pilot/logs/scan_log.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "frontier_pilot/core/bounds.h"
#include "logs/carmen_log.h"
#include "logs/csv_log.h"
#include "logs/text_reader.h"

namespace frontier_pilot::logs {

namespace {

/// Whether a rosbag of any version begins like this.
bool beginsBag(const std::string& line) {
  constexpr std::array<const char*, 3> kMagics = {"#ROSBAG", "#ROSRECORD", "#ROSLOG"};
  return std::any_of(kMagics.begin(), kMagics.end(), [&](const char* magic) { return line.rfind(magic, 0) == 0; });
}

/// Skips the mark with which some editors begin a text in UTF-8.
void skipByteOrderMark(std::istream& file) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  const auto begin = file.tellg();
  std::array<char, kMark.size()> bytes{};
  if (file.read(bytes.data(), bytes.size()) && std::string_view(bytes.data(), bytes.size()) == kMark) return;
  file.clear();
  file.seekg(begin);
}

}  // namespace

LogFormat formatOf(std::istream& file) {
  skipByteOrderMark(file);
  const auto begin = file.tellg();
  std::string line;
  bool comment = true;
  while (comment && readLine(file, line) && line.size() <= kMostLineBytes) {
    comment = line.find_first_not_of(" \t\r") == std::string::npos || (line[0] == '#' && !beginsBag(line));
  }
  file.clear();
  file.seekg(begin);
  if (beginsBag(line)) return LogFormat::kRosbag;
  const bool starts_with_number = line.find_first_of("0123456789") <= line.find_first_not_of(" \t+-.");
  return starts_with_number && line.find(',') != std::string::npos ? LogFormat::kCsv : LogFormat::kCarmen;
}

namespace {

/// What determines the size of the map that is made of a log has the bounds that it has in messages.
ScanLog checked(ScanLog log, const std::string& name, const LogScanner& scanner) {
  for (LogRecord& record : log.records) {
    const Pose2& base = record.T_odom_base;
    if (!bounds::isWithin(base.position().cwiseAbs().maxCoeff(), bounds::kMostCoordinate))
      throw LogError(name + ": odometry is farther than 1000 km from the origin");
    if (!bounds::isWithin(record.scan.T_base_sensor.position().norm(), bounds::kMostMount))
      throw LogError(name + ": the laser is farther than 10 m from the robot");
    record.scan.range_max = std::min(record.scan.range_max, bounds::kUsedRange);  // what is longer is no return
  }
  if (!scanner.range_max) recogniseMissingReturns(log);
  return log;
}

}  // namespace

void requireOneDrive(const ScanLog& log, const std::string& name) {
  constexpr Duration kMostDisorder = std::chrono::seconds(10);
  Time latest{};
  for (std::size_t i = 0; i < log.records.size(); ++i) {
    const Time stamp = log.records[i].scan.stamp;
    if (latest - stamp > kMostDisorder)
      throw LogError(name + ": scan " + std::to_string(i + 1) + " is " +
                     std::to_string(std::lround(toSeconds(latest - stamp))) +
                     " s older than one before it: are these several drives in one file? Each needs a file of its own");
    latest = std::max(latest, stamp);
  }
  const bool all_at_once = std::all_of(log.records.begin(), log.records.end(), [&](const LogRecord& record) {
    return record.scan.stamp == log.records.front().scan.stamp;
  });
  if (log.records.size() > 1 && all_at_once)
    throw LogError(name + ": all of its " + std::to_string(log.records.size()) +
                   " scans have the same time stamp, so that only the first could be mapped");
}

ScanLog readScanLog(std::istream& file, const std::string& name, const LogScanner& scanner) {
  switch (formatOf(file)) {
    case LogFormat::kCsv:
      return checked(readCsvLog(file, name, scanner), name, scanner);
    case LogFormat::kCarmen:
      return checked(readCarmenLog(file, name, scanner), name, scanner);
    case LogFormat::kRosbag:
      break;
  }
  throw LogError(name + ": is a rosbag, which this program cannot read: it was built without ROS");
}

}  // namespace frontier_pilot::logs
