#include "logs/csv_log.h"

#include <utility>

#include "logs/text_reader.h"

namespace frontier_pilot::logs {
namespace {

const Pose2 kMount(0.78, 0.0, 0.0);
constexpr double kCsvRangeMax = 80.0;  // [m]

Pose2 readPose(TextReader& reader) {
  Pose2 pose;
  pose.x = reader.number("odometry's x");
  pose.y = reader.number("odometry's y");
  pose.yaw = normalizeAngle(reader.number("odometry's yaw"));
  return pose;
}

LogRecord readRecord(TextReader& reader, const LogScanner& scanner) {
  LogRecord record;
  record.scan.stamp = timeFromSeconds(reader.number("the stamp"));
  record.T_odom_base = readPose(reader);
  if (reader.wordsLeft() < 2) reader.fail("a scan has at least two ranges");
  record.scan.ranges.reserve(reader.wordsLeft());
  while (!reader.atEnd()) record.scan.ranges.push_back(static_cast<float>(reader.number("a range")));
  const double field_of_view = scanner.field_of_view.value_or(kPi);
  record.scan.angle_min = -0.5 * field_of_view;
  record.scan.angle_increment = field_of_view / static_cast<double>(record.scan.ranges.size() - 1);
  record.scan.range_max = scanner.range_max.value_or(kCsvRangeMax);
  record.scan.T_base_sensor = scanner.T_base_sensor.value_or(kMount);
  return record;
}

}  // namespace

ScanLog readCsvLog(std::istream& file, const std::string& name, const LogScanner& scanner) {
  TextReader reader(file, name, ", \t\r");
  ScanLog log;
  while (reader.nextLine()) {
    LogRecord record = readRecord(reader, scanner);
    const std::size_t beams = record.scan.ranges.size();
    const std::size_t expected = log.records.empty() ? beams : log.records.front().scan.ranges.size();
    if (beams != expected) {
      reader.fail("has " + std::to_string(beams) + " ranges, the first scan has " + std::to_string(expected));
    }
    reader.keep(sizeof(record) + beams * sizeof(float));
    log.records.push_back(std::move(record));
  }
  if (log.records.empty()) throw LogError(name + ": holds no scan");
  return log;
}

}  // namespace frontier_pilot::logs
