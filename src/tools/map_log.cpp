#include "tools/map_log.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/logs/trajectory.h"
#include "frontier_pilot/map_files/map_io.h"
#include "tools/log_mapping.h"
#include "tools/map_picture.h"
#include "tools/program.h"

namespace frontier_pilot::tools {
namespace {

constexpr int kDone = 0;

double cpuSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::ifstream openFile(const std::string& path) {
  std::error_code error;
  const bool odd = std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error);
  if (odd) throw logs::LogError(path + ": is not a regular file");
  std::ifstream file(path, std::ios::binary);
  if (!file || file.peek() == std::ifstream::traits_type::eof())
    throw logs::LogError(path + ": cannot be read, or is empty");
  return file;
}

/// The log of a rosbag, which says itself where its scanner sits and looks. Throws std::invalid_argument if that is
/// given.
logs::ScanLog readBag(const MapLogOptions& options, const BagReader& read_bag) {
  const logs::LogScanner& given = options.scanner;
  if (given.field_of_view || given.T_base_sensor)
    throw std::invalid_argument(
        "--fov and --mount are not for a rosbag: its scans say their field of view, and its transforms where the "
        "scanner sits on the base");
  logs::ScanLog log = read_bag(options.log, options.topics);
  if (!given.range_max) return log;
  for (logs::LogRecord& record : log.records) record.scan.range_max = std::min(record.scan.range_max, *given.range_max);
  return log;
}

logs::ScanLog readLog(const MapLogOptions& options, const BagReader& read_bag) {
  std::ifstream file = openFile(options.log);
  const bool is_bag = read_bag && logs::formatOf(file) == logs::LogFormat::kRosbag;
  logs::ScanLog log = is_bag ? readBag(options, read_bag) : logs::readScanLog(file, options.log, options.scanner);
  logs::requireOneDrive(log, options.log);
  return log;
}

/// What is written for `--out`, by what is appended to it.
constexpr std::array kResults{".pgm", ".yaml", ".bt", ".tum", "_odom.tum", ".png"};
constexpr std::size_t kLongestEnding = std::string_view("_odom.tum").size();

/// Throws LogError if no result can be written there, or if one would replace what is read: before the drive is mapped,
/// which may take an hour.
void requireWritable(const MapLogOptions& options) {
  const std::string& out = options.out;
  const std::filesystem::path path(out);
  const std::string problem = fileNameProblem(path.filename().string(), kLongestEnding);
  if (!problem.empty()) throw logs::LogError("--out: the map's name " + problem);
  const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
  if (access(folder.c_str(), W_OK | X_OK) != 0)
    throw logs::LogError(out + ": cannot be written, the folder " + folder + ": " + std::strerror(errno));
  for (const char* ending : kResults) {
    std::error_code error;
    if (std::filesystem::is_directory(std::filesystem::symlink_status(out + ending, error)))
      throw logs::LogError(out + ending + ": cannot be written, it is a folder");
    for (const std::string& input : {options.log, options.relations}) {
      if (std::filesystem::equivalent(input, out + ending, error))
        throw logs::LogError(input + ": would be replaced by a result, choose another --out");
    }
  }
}

double lengthOf(const logs::Trajectory& trajectory) {
  double length = 0.0;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    length += (trajectory[i].pose.position() - trajectory[i - 1].pose.position()).norm();
  }
  return length;
}

Polyline polylineOf(const logs::Trajectory& trajectory) {
  Polyline track;
  for (const StampedPose2& entry : trajectory) track.push_back(entry.pose.position());
  return track;
}

void printLog(const logs::ScanLog& log, const MappedDrive& drive) {
  for (const std::string& note : log.notes) std::printf("note: %s\n", note.c_str());
  const double seconds = toSeconds(log.records.back().scan.stamp - log.records.front().scan.stamp);
  std::printf("log: %zu scans of %zu beams, %.1f s, %.1f m by odometry\n", log.records.size(),
              log.records.front().scan.ranges.size(), seconds, lengthOf(drive.odometry));
}

/// The closures as lines between corrected positions: from the recognised place to where it was recognised.
std::vector<std::pair<Vec2, Vec2>> closuresOf(const MappedDrive& drive) {
  const auto at = [&](Time stamp) {
    const auto later = std::lower_bound(drive.corrected.begin(), drive.corrected.end(), stamp,
                                        [](const StampedPose2& entry, Time time) { return entry.stamp < time; });
    return (later == drive.corrected.end() ? drive.corrected.back() : *later).pose.position();
  };
  std::vector<std::pair<Vec2, Vec2>> lines;
  for (const slam::LoopClosure& closure : drive.closures)
    lines.emplace_back(at(closure.reference_stamp), at(closure.keyframe_stamp));
  return lines;
}

void printCounts(const mapping::Mapper& mapper, double cpu) {
  std::printf("scans:");
  for (std::size_t i = 0; i < mapping::kScanVerdicts; ++i) {
    const auto verdict = static_cast<mapping::ScanVerdict>(i);
    if (mapper.counts()[verdict] == 0) continue;
    std::printf(" %s %llu", toString(verdict), static_cast<unsigned long long>(mapper.counts()[verdict]));
  }
  std::printf("\nmatches:");
  for (const auto& [text, count] : mapper.correctionCounts()) {
    std::printf(" %s %llu", text.c_str(), static_cast<unsigned long long>(count));
  }
  std::printf("\nclosures: %llu, map rendered again %llu times\n",
              static_cast<unsigned long long>(mapper.revisions().closures),
              static_cast<unsigned long long>(mapper.revisions().rendered));
  std::printf("cpu: %.2f s\n", cpu);
}

void printError(const char* what, const logs::Trajectory& trajectory,
                const std::vector<logs::PoseRelation>& relations) {
  const logs::RelationError error = logs::relationError(posesOf(trajectory), relations);
  std::printf("%s: translation %.3f +- %.3f m, rotation %.2f +- %.2f deg from %zu relations\n", what,
              error.translation.mean, error.translation.stddev, error.rotation.mean * 180.0 / kPi,
              error.rotation.stddev * 180.0 / kPi, relations.size());
}

std::vector<logs::PoseRelation> relationsOf(const MapLogOptions& options, std::size_t poses) {
  if (options.relations.empty()) return {};
  std::ifstream file = openFile(options.relations);
  return logs::readRelations(file, options.relations, poses);
}

void printErrors(const std::vector<logs::PoseRelation>& relations, const MappedDrive& drive) {
  if (relations.empty()) return;
  printError("odometry ", drive.odometry, relations);
  printError("corrected", drive.corrected, relations);
}

void writeTrajectory(const logs::Trajectory& trajectory, const std::string& path) {
  std::ostringstream text;
  logs::writeTum(text, trajectory);
  const std::string problem = writeFile(path, text.str());
  if (!problem.empty()) throw logs::LogError(path + ": cannot be written: " + problem);
}

void writeResults(const MapLogOptions& options, const MappedDrive& drive, mapping::Mapper& mapper) {
  // The map is the largest of them: what a full disk does not take leaves the results of before.
  const map_files::MapIoResult saved = map_files::saveMap(mapper.map(), options.out);
  if (!saved.ok()) throw logs::LogError(saved.text);
  writeTrajectory(drive.corrected, options.out + ".tum");
  writeTrajectory(drive.odometry, options.out + "_odom.tum");
  const MapPicture picture{polylineOf(drive.odometry), polylineOf(drive.corrected), closuresOf(drive)};
  const std::string path = options.out + ".png";
  if (!writePicture(mapper.grid(), picture, path)) throw logs::LogError(path + ": cannot be written");
  std::printf("%s\nsaved %s.tum, _odom.tum and .png\n", saved.text.c_str(), options.out.c_str());
}

int run(const MapLogOptions& options, const BagReader& read_bag) {
  requireWritable(options);
  const logs::ScanLog log = readLog(options, read_bag);
  const std::vector<logs::PoseRelation> relations = relationsOf(options, log.records.size());
  mapping::Mapper mapper(options.mapper);
  const double begin = cpuSeconds();
  const MappedDrive drive = mapLog(log, mapper);
  const double cpu = cpuSeconds() - begin;
  printLog(log, drive);
  printCounts(mapper, cpu);
  printErrors(relations, drive);
  writeResults(options, drive, mapper);
  return kDone;
}

}  // namespace

int runMapLog(const std::vector<std::string>& words, const BagReader& read_bag) {
  return runProgram("map_log", words, mapLogUsage(), [&read_bag](const std::vector<std::string>& given) {
    return run(parseMapLogOptions(given), read_bag);
  });
}

}  // namespace frontier_pilot::tools
