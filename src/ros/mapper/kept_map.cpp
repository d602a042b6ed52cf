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

/// Maps that the same node has left in other sessions, the newest first.
std::vector<fs::path> olderMaps(const fs::path& own) {
  std::vector<std::pair<fs::file_time_type, fs::path>> found;
  std::error_code ignored;
  for (const auto& session : fs::directory_iterator(own.parent_path().parent_path(), ignored)) {
    const fs::path base = session.path() / own.filename();
    const auto written = fs::last_write_time(base.string() + ".bt", ignored);
    if (base != own && !ignored) found.emplace_back(written, base);
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
  for (std::size_t i = kMostOlder; i < maps.size(); ++i) {
    removeFiles(maps[i]);
    removeFiles(lostMap(maps[i]));
  }
}

std::string setAside(const fs::path& base) {
  const fs::path lost = lostMap(base);
  std::error_code error;
  fs::create_directories(lost.parent_path(), error);
  for (const char* ending : kEndings) {
    if (!error) fs::rename(base.string() + ending, lost.string() + ending, error);
  }
  return error ? std::string() : lost.string();
}

}  // namespace frontier_pilot::kept_map
