#include "logs/carmen_log.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "frontier_pilot/core/motion.h"
#include "logs/text_reader.h"

namespace frontier_pilot::logs {
namespace {

constexpr const char* kFrontLaser = "FLASER";
constexpr const char* kRobotLaser = "ROBOTLASER1";
constexpr double kDegree = kPi / 180.0;
constexpr double kRangeMax = 80.0;        // [m]: scanners of that time report slightly more when nothing returns
constexpr double kMountTolerance = 0.02;  // [m] and [rad]: poses in a log are rounded

/// A record, and the scanner's pose in the odometry frame as the log has it.
struct CarmenRecord {
  LogRecord record;
  Pose2 T_odom_sensor;
};

Pose2 readPose(TextReader& reader, const char* what) {
  Pose2 pose;
  pose.x = reader.number(what);
  pose.y = reader.number(what);
  pose.yaw = normalizeAngle(reader.number(what));
  return pose;
}

void readRanges(TextReader& reader, LaserScan2& scan) {
  const std::size_t count = reader.count("the number of ranges");
  if (count < 2) reader.fail("a scan has at least two ranges");
  if (count > reader.wordsLeft()) reader.fail("has fewer ranges than it says");
  scan.ranges.reserve(count);
  for (std::size_t i = 0; i < count; ++i) scan.ranges.push_back(static_cast<float>(reader.number("a range")));
}

/// Sets the angles that CARMEN assumes for a number of ranges: a SICK scanner with steps of 1, 0.5 or 0.25 degrees.
void guessAngles(LaserScan2& scan, std::optional<double> field_of_view) {
  const std::size_t beams = scan.ranges.size();
  const auto spread = [&](double angle) {
    scan.angle_min = -0.5 * angle;
    scan.angle_increment = angle / static_cast<double>(beams - 1);
  };
  if (field_of_view) return spread(*field_of_view);
  if (beams == 401 || beams == 400) return spread(0.25 * kDegree * static_cast<double>(beams - 1));
  spread(kPi);
  if (beams == 180) scan.angle_increment = kDegree;
  if (beams == 360) scan.angle_increment = 0.5 * kDegree;
}

void readPoses(TextReader& reader, CarmenRecord& read) {
  read.T_odom_sensor = readPose(reader, "the laser's pose");
  read.record.T_odom_base = readPose(reader, "the robot's pose");
}

CarmenRecord readFrontLaser(TextReader& reader, const LogScanner& scanner) {
  CarmenRecord read;
  LaserScan2& scan = read.record.scan;
  readRanges(reader, scan);
  guessAngles(scan, scanner.field_of_view);
  scan.range_max = scanner.range_max.value_or(kRangeMax);
  readPoses(reader, read);
  scan.stamp = timeFromSeconds(reader.number("the stamp"));
  return read;
}

void readLaserConfiguration(TextReader& reader, const LogScanner& scanner, LaserScan2& scan) {
  reader.skip(1, "the laser's type");
  scan.angle_min = reader.number("the start angle");
  reader.skip(1, "the field of view");
  scan.angle_increment = reader.number("the angular resolution");
  if (scan.angle_increment == 0.0) reader.fail("the angular resolution is zero");
  const double range_max = reader.number("the maximum range");
  scan.range_max = scanner.range_max.value_or(range_max);
  if (scan.range_max <= 0.0) reader.fail("the maximum range is not positive");
  reader.skip(2, "accuracy and remission mode");
}

CarmenRecord readRobotLaser(TextReader& reader, const LogScanner& scanner) {
  CarmenRecord read;
  LaserScan2& scan = read.record.scan;
  readLaserConfiguration(reader, scanner, scan);
  readRanges(reader, scan);
  reader.skip(reader.count("the number of remissions"), "a remission");
  readPoses(reader, read);
  reader.skip(5, "the velocities and safety distances");
  scan.stamp = timeFromSeconds(reader.number("the stamp"));
  return read;
}

/// The scanner's pose on the base, if it is the same in all records.
std::optional<Pose2> commonMount(const std::vector<CarmenRecord>& read) {
  const auto mountOf = [](const CarmenRecord& r) { return r.record.T_odom_base.inverse() * r.T_odom_sensor; };
  const Pose2 first = mountOf(read.front());
  const bool common = std::none_of(read.begin(), read.end(), [&](const CarmenRecord& r) {
    return isJump(first, mountOf(r), kMountTolerance, kMountTolerance);
  });
  return common ? std::optional<Pose2>(first) : std::nullopt;
}

void mountScanner(std::vector<CarmenRecord>& read, const LogScanner& scanner, std::vector<std::string>& notes) {
  const std::optional<Pose2> mount = scanner.T_base_sensor ? scanner.T_base_sensor : commonMount(read);
  if (!mount) notes.emplace_back("the laser's pose on the robot varies: the laser is assumed at the robot's centre");
  for (CarmenRecord& r : read) r.record.scan.T_base_sensor = mount.value_or(Pose2());
}

}  // namespace

ScanLog readCarmenLog(std::istream& file, const std::string& name, const LogScanner& scanner) {
  TextReader reader(file, name, " \t\r");
  std::vector<CarmenRecord> read;
  std::string kind;
  std::size_t others = 0;
  while (reader.nextLine()) {
    const std::string_view message = reader.word("a message's name");
    if (message != kFrontLaser && message != kRobotLaser) continue;
    if (kind.empty()) kind = message;
    if (message != kind) {
      ++others;
      continue;
    }
    read.push_back(message == kFrontLaser ? readFrontLaser(reader, scanner) : readRobotLaser(reader, scanner));
    reader.keep(sizeof(CarmenRecord) + read.back().record.scan.ranges.size() * sizeof(float));
  }
  if (read.empty())
    throw LogError(
        name +
        ": holds no FLASER and no ROBOTLASER1 line, and is no CSV file: its first line should begin with a number");
  ScanLog log;
  if (others > 0) log.notes.push_back(std::to_string(others) + " scans of another kind than " + kind + " skipped");
  mountScanner(read, scanner, log.notes);
  for (CarmenRecord& r : read) log.records.push_back(std::move(r.record));
  return log;
}

}  // namespace frontier_pilot::logs
