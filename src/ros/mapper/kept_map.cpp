#include "ros/mapper/kept_map.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

namespace frontier_pilot::kept_map {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOlder = 3;
constexpr const char* kEndings[] = {".bt", ".pgm", ".yaml"};

/// The files keep their names, because one of them contains those of the others.
fs::path lostMap(const fs::path& base) { return base.parent_path() / "lost" / base.filename(); }

/// Maps that the same node has left in other sessions, put aside or not, the newest first.
std::vector<fs::path> olderMaps(const fs::path& own) {
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  std::error_code ignored;
  for (const auto& session : fs::directory_iterator(own.parent_path().parent_path(), ignored)) {
    const fs::path base = session.path() / own.filename();
    if (base == own) continue;
    for (const fs::path& map : {base, lostMap(base)}) {
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

}  // namespace

bool exists(const fs::path& base) {
  std::error_code ignored;
  return fs::exists(base.string() + ".bt", ignored);
}

void removeFiles(const fs::path& base) {
  std::error_code ignored;
  for (const char* ending : kEndings) fs::remove(base.string() + ending, ignored);
}

void removeOldest(const fs::path& own) {
  const std::vector<fs::path> maps = olderMaps(own);
  for (std::size_t i = kMostOlder; i < maps.size(); ++i) removeFiles(maps[i]);
}

std::string setAside(const fs::path& base) {
  const fs::path lost = lostMap(base);
  std::error_code ignored;  // the picture and its description may be missing
  fs::create_directories(lost.parent_path(), ignored);
  removeFiles(lost);
  for (const char* ending : kEndings) fs::rename(base.string() + ending, lost.string() + ending, ignored);
  return kept_map::exists(lost) ? lost.string() : std::string();
}

}  // namespace frontier_pilot::kept_map
