#include "ros/mapper/kept_map.h"

#include <algorithm>
#include <chrono>
#include <iomanip>
#include <iterator>
#include <limits>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/clock.h"
#include "ros/common/memory/disk.h"
#include "ros/common/memory/session_memory.h"
#include "ros/common/messages/message_problems.h"

namespace frontier_pilot::kept_map {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOlder = 3;
constexpr const char* kEndings[] = {".bt", ".pgm", ".yaml"};

constexpr int kMostLost = 9;

/// Where the `k`-th lost map lies, from 1. The files keep their names, because one of them contains those of the
/// others.
fs::path lostMap(const fs::path& base, int k) {
  return base.parent_path() / (k == 1 ? "lost" : "lost." + std::to_string(k)) / base.filename();
}

/// Whether all files that there are of the map have been moved.
bool move(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  for (const char* ending : kEndings) fs::rename(from.string() + ending, to.string() + ending, error);
  return kept_map::exists(to) && !kept_map::exists(from);
}

/// Maps that the same node has left in other sessions, put aside or not, the newest first. Without that of a mapper
/// which runs in another session: its pose lies beside the map, in the file `base`.
std::vector<fs::path> olderMaps(const fs::path& own) {
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  for (const fs::path& session : entriesOf(own.parent_path().parent_path())) {
    const fs::path base = session / own.filename();
    if (base == own) continue;
    for (int k = 0; k <= kMostLost; ++k) {
      if (k == 0 && isKeptByALivingProcess(base)) continue;
      const fs::path map = k == 0 ? base : lostMap(base, k);
      std::error_code missing;
      const auto written = fs::last_write_time(map.string() + ".bt", missing);
      if (!missing) found.emplace_back(written, map);
    }
  }
  std::sort(found.rbegin(), found.rend());
  std::vector<fs::path> maps;
  for (auto& [written, base] : found) maps.push_back(std::move(base));
  return maps;
}

/// Whether `name` is that of a file of the map `base` that was not written to its end: AtomicFile appends a dot and
/// eleven characters.
bool isUnfinished(const std::string& name, const std::string& base) {
  return std::any_of(std::begin(kEndings), std::end(kEndings), [&](const char* ending) {
    const std::string target = base + ending + ".";
    return name.size() == target.size() + 11 && name.rfind(target, 0) == 0;
  });
}

/// Removes what processes that were killed while they saved have left. A file that is older than saving can take is not
/// being written any more.
void removeUnfinished(const fs::path& own) {
  const fs::file_time_type since = fs::file_time_type::clock::now() - std::chrono::minutes(10);
  for (const fs::path& session : entriesOf(own.parent_path().parent_path())) {
    for (const fs::path& file : entriesOf(session)) {
      if (!isUnfinished(file.filename().string(), own.filename().string())) continue;
      std::error_code missing;
      const auto written = fs::last_write_time(file, missing);
      if (!missing && written < since) fs::remove(file, missing);
    }
  }
}

}  // namespace

bool exists(const fs::path& base) {
  std::error_code ignored;
  return std::any_of(std::begin(kEndings), std::end(kEndings), [&](const char* ending) {
    return fs::exists(fs::symlink_status(base.string() + ending, ignored));
  });
}

void removeFiles(const fs::path& base) {
  std::error_code ignored;
  for (const char* ending : kEndings) fs::remove(base.string() + ending, ignored);
}

void removeOldest(const fs::path& own) {
  removeUnfinished(own);
  const std::vector<fs::path> maps = olderMaps(own);
  for (std::size_t i = kMostOlder; i < maps.size(); ++i) removeFiles(maps[i]);
}

std::string setAside(const fs::path& base) {
  for (int k = 1; k <= kMostLost; ++k) {
    const fs::path lost = lostMap(base, k);
    if (k == kMostLost) removeFiles(lost);
    if (!kept_map::exists(lost) && move(base, lost)) return lost.string();
  }
  return {};
}

std::string whereItIs(const std::string& lost) {
  const fs::path folder = fs::path(lost).parent_path();
  std::string words = "mapper/load_map may still read " + lost;
  if (folder.filename() != "lost." + std::to_string(kMostLost)) return words;
  return words + ", the last of " + std::to_string(kMostLost) +
         " folders, where each map that is put aside replaces the one before it: remove from " +
         folder.parent_path().string() + " what is not needed";
}

std::string lastSetAside(const fs::path& base) {
  for (int k = kMostLost; k >= 1; --k) {
    if (kept_map::exists(lostMap(base, k))) return lostMap(base, k).string();
  }
  return {};
}

std::string renew(const std::vector<fs::path>& poses) {
  std::string problem;
  for (const fs::path& pose : poses) {
    std::error_code error;
    fs::last_write_time(pose, fs::file_time_type::clock::now(), error);
    if (error) problem = pose.string() + ": " + error.message();
  }
  return problem;
}

std::string tryForAWhile(const std::function<std::string()>& attempt) {
  const SteadyTime end = steadyNow() + std::chrono::seconds(2);
  for (;;) {
    std::string problem = attempt();
    if (problem.empty() || steadyNow() >= end) return problem;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace frontier_pilot::kept_map

namespace frontier_pilot {
namespace {

constexpr const char* kLocalized = "localized";
constexpr const char* kMapFile = " map_file:=";
constexpr std::size_t kLongestPath = 4096;  // [bytes], which is that of Linux

}  // namespace

std::string mapFileName(const std::string& map_file) {
  if (map_file.empty()) return {};
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(map_file, error);
  return printable(error ? map_file : whole.lexically_normal().string(), kLongestPath);
}

std::string toText(const KeptPose& pose) {
  const Pose2& T_map_odom = pose.T_map_odom;
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10) << T_map_odom.x << ' ' << T_map_odom.y << ' '
       << T_map_odom.yaw;
  if (pose.localized) text << ' ' << kLocalized;
  if (pose.map_file) text << kMapFile << *pose.map_file;
  return text.str();
}

std::optional<KeptPose> toKeptPose(const std::string& text) {
  std::istringstream in(text);
  KeptPose kept;
  Pose2& pose = kept.T_map_odom;
  if (!(in >> pose.x >> pose.y >> pose.yaw)) return std::nullopt;
  const bool has_place = problemOfPlace(pose.x, pose.y, 0.0).empty();
  if (!has_place || !bounds::isWithin(pose.yaw, 2.0 * kPi)) return std::nullopt;
  std::string word;
  kept.localized = in >> word && word == kLocalized;
  const std::size_t at = text.find(kMapFile);
  if (at != text.npos) kept.map_file = text.substr(at + std::string(kMapFile).size());
  return kept;
}

}  // namespace frontier_pilot
