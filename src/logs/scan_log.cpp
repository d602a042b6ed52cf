#include "frontier_pilot/logs/scan_log.h"

#include "logs/carmen_log.h"
#include "logs/csv_log.h"

namespace frontier_pilot::logs {

LogFormat formatOf(std::istream& file) {
  constexpr const char* kBagMagic = "#ROSBAG";
  const auto begin = file.tellg();
  std::string line;
  bool comment = true;
  while (comment && std::getline(file, line)) {
    comment = line.find_first_not_of(" \t\r") == std::string::npos || (line[0] == '#' && line.rfind(kBagMagic, 0) != 0);
  }
  file.clear();
  file.seekg(begin);
  if (line.rfind(kBagMagic, 0) == 0) return LogFormat::kRosbag;
  const bool starts_with_number = line.find_first_of("0123456789") <= line.find_first_not_of(" \t+-.");
  return starts_with_number && line.find(',') != std::string::npos ? LogFormat::kCsv : LogFormat::kCarmen;
}

ScanLog readScanLog(std::istream& file, const std::string& name, const LogScanner& scanner) {
  switch (formatOf(file)) {
    case LogFormat::kCsv:
      return readCsvLog(file, name, scanner);
    case LogFormat::kCarmen:
      return readCarmenLog(file, name, scanner);
    case LogFormat::kRosbag:
      break;
  }
  throw LogError(name + ": is a rosbag, which this program cannot read: it was built without ROS");
}

}  // namespace frontier_pilot::logs
