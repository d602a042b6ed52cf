#include "ros/map_log/packed_log.h"

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace frontier_pilot {
namespace {

class Packer {
 public:
  explicit Packer(std::string& bytes) : bytes_(bytes) {}
  template <class T>
  void number(const T& value) {
    static_assert(std::is_arithmetic_v<T>, "numbers only");
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void text(const std::string& text) {
    number(text.size());
    bytes_ += text;
  }
  void pose(const Pose2& pose) {
    for (const double value : {pose.x, pose.y, pose.yaw}) number(value);
  }
  void record(const logs::LogRecord& record) {
    const LaserScan2& scan = record.scan;
    pose(record.T_odom_base);
    pose(scan.T_base_sensor);
    number(scan.stamp.time_since_epoch().count());
    for (const double value : {scan.angle_min, scan.angle_increment, scan.range_min, scan.range_max}) number(value);
    number(scan.ranges.size());
    for (const float range : scan.ranges) number(range);
    number(scan.moving_mounts.size());
    for (const Pose2& mount : scan.moving_mounts) pose(mount);
  }

 private:
  std::string& bytes_;
};

/// Reads what a Packer has written; throws std::length_error if bytes are missing.
class Unpacker {
 public:
  explicit Unpacker(std::string_view rest) : rest_(rest) {}
  template <class T>
  T number() {
    T value{};
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string text() { return std::string(take(number<std::size_t>())); }
  Pose2 pose() {
    const auto x = number<double>();
    const auto y = number<double>();
    return {x, y, number<double>()};
  }
  logs::LogRecord record() {
    logs::LogRecord record;
    LaserScan2& scan = record.scan;
    record.T_odom_base = pose();
    scan.T_base_sensor = pose();
    scan.stamp = Time(Duration(number<Duration::rep>()));
    for (double* value : {&scan.angle_min, &scan.angle_increment, &scan.range_min, &scan.range_max}) {
      *value = number<double>();
    }
    const auto ranges = number<std::size_t>();
    if (ranges > rest_.size() / sizeof(float)) throw std::length_error("ranges");
    scan.ranges.resize(ranges);
    for (float& range : scan.ranges) range = number<float>();
    const auto mounts = number<std::size_t>();
    if (mounts != 0 && mounts != ranges) throw std::length_error("mounts");
    for (std::size_t i = 0; i < mounts; ++i) scan.moving_mounts.push_back(pose());
    return record;
  }
  bool atEnd() const { return rest_.empty(); }

 private:
  std::string_view take(std::size_t size) {
    if (size > rest_.size()) throw std::length_error("the end");
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return taken;
  }

  std::string_view rest_;
};

}  // namespace

std::string packLog(const logs::ScanLog& log) {
  std::string bytes;
  Packer packer(bytes);
  packer.number(log.notes.size());
  for (const std::string& note : log.notes) packer.text(note);
  packer.number(log.records.size());
  for (const logs::LogRecord& record : log.records) packer.record(record);
  return bytes;
}

logs::ScanLog unpackLog(std::string_view bytes) {
  Unpacker unpacker(bytes);
  logs::ScanLog log;
  for (auto notes = unpacker.number<std::size_t>(); notes > 0; --notes) log.notes.push_back(unpacker.text());
  for (auto left = unpacker.number<std::size_t>(); left > 0; --left) log.records.push_back(unpacker.record());
  if (log.records.empty()) throw std::length_error("no scan");
  if (!unpacker.atEnd()) throw std::length_error("bytes after the end");
  return log;
}

}  // namespace frontier_pilot
