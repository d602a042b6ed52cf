#include "frontier_pilot/mapping/map_io.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

// map_server's trinary format: how dark a pixel is says how occupied it is.
constexpr double kOccupiedThreshold = 0.65;
constexpr double kFreeThreshold = 0.196;
constexpr unsigned char kFreePixel = 254;
constexpr unsigned char kOccupiedPixel = 0;
constexpr unsigned char kUnknownPixel = 205;

MapIoResult failure(MapIoStatus status, const std::string& file, const std::string& what) {
  return {status, file + ": " + what};
}

/// A file that takes its place only when it is whole; one that does not get there is removed.
class PendingFile {
 public:
  explicit PendingFile(fs::path path) : path_(std::move(path)), temporary_(path_.string() + ".part") {}
  ~PendingFile() {
    std::error_code ignored;
    fs::remove(temporary_, ignored);
  }
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  bool write(const std::string& content) const {
    std::ofstream file(temporary_, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
    return file.good();
  }
  bool commit() const {
    std::error_code error;
    fs::rename(temporary_, path_, error);
    return !error;
  }
  std::string name() const { return path_.string(); }

 private:
  fs::path path_;
  fs::path temporary_;
};

unsigned char pixelOf(std::int8_t value) {
  if (isUnknown(value)) return kUnknownPixel;
  return isOccupied(value) ? kOccupiedPixel : kFreePixel;
}

std::string pgmOf(const OccupancyGrid& grid) {
  cv::Mat image(grid.height(), grid.width(), CV_8UC1);
  for (int y = 0; y < grid.height(); ++y) {
    // An image's first row is its upper edge.
    std::transform(grid.row(y), grid.row(y) + grid.width(), image.ptr(grid.height() - 1 - y), pixelOf);
  }
  std::vector<unsigned char> bytes;
  cv::imencode(".pgm", image, bytes);
  return {bytes.begin(), bytes.end()};
}

std::string yamlOf(const GridGeometry& geometry, const std::string& image) {
  std::ostringstream yaml;
  yaml << std::setprecision(std::numeric_limits<double>::digits10);
  yaml << "image: " << image << "\nresolution: " << geometry.resolution << "\norigin: [" << geometry.origin.x() << ", "
       << geometry.origin.y() << ", 0.0]\nnegate: 0\noccupied_thresh: " << kOccupiedThreshold
       << "\nfree_thresh: " << kFreeThreshold << "\n";
  return yaml.str();
}

fs::path withoutExtension(const std::string& path) {
  const fs::path whole(path);
  const std::string extension = whole.extension().string();
  const bool ours = extension == ".pgm" || extension == ".yaml" || extension == ".bt";
  return ours ? fs::path(whole).replace_extension() : whole;
}

MapIoResult checkTarget(const fs::path& base, const std::string& path) {
  if (base.filename().empty()) return failure(MapIoStatus::kBadPath, "'" + path + "'", "names no file");
  const fs::path directory = base.has_parent_path() ? base.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(directory, error))
    return failure(MapIoStatus::kBadPath, directory.string(), "no such directory");
  return {};
}

MapIoResult writeAll(const std::vector<std::pair<const PendingFile*, std::string>>& files) {
  for (const auto& [file, content] : files) {
    if (!file->write(content)) return failure(MapIoStatus::kCannotWrite, file->name(), "cannot be written");
  }
  for (const auto& [file, content] : files) {
    if (!file->commit()) return failure(MapIoStatus::kCannotWrite, file->name(), "cannot be put in its place");
  }
  return {};
}

std::string appended(const fs::path& base, const char* extension) { return base.string() + extension; }

}  // namespace

const char* toString(MapIoStatus status) {
  switch (status) {
    case MapIoStatus::kOk:
      return "ok";
    case MapIoStatus::kBadPath:
      return "bad path";
    case MapIoStatus::kEmptyMap:
      return "empty map";
    case MapIoStatus::kCannotWrite:
      return "cannot write";
    case MapIoStatus::kMissing:
      return "missing file";
    case MapIoStatus::kBroken:
      return "broken file";
  }
  return "unknown";
}

MapIoResult saveMap(OccupancyMap& map, const std::string& path) {
  const fs::path base = withoutExtension(path);
  MapIoResult target = checkTarget(base, path);
  if (!target.ok()) return target;
  if (map.grid().empty()) return {MapIoStatus::kEmptyMap, "there is no map yet"};
  std::ostringstream octree;
  if (!map.write(octree)) return {MapIoStatus::kCannotWrite, "the octree cannot be written"};
  const PendingFile pgm(appended(base, ".pgm"));
  const PendingFile yaml(appended(base, ".yaml"));
  const PendingFile bt(appended(base, ".bt"));
  const std::string image = fs::path(pgm.name()).filename().string();
  MapIoResult result =
      writeAll({{&pgm, pgmOf(map.grid())}, {&yaml, yamlOf(map.geometry(), image)}, {&bt, octree.str()}});
  if (result.ok()) result.text = "saved " + base.string() + ".pgm, .yaml and .bt";
  return result;
}

MapIoResult loadMap(const std::string& path, OccupancyMap& map) {
  const fs::path base = withoutExtension(path);
  if (base.filename().empty()) return failure(MapIoStatus::kBadPath, "'" + path + "'", "names no file");
  return loadOctree(appended(base, ".bt"), map);
}

MapIoResult loadOctree(const std::string& bt_path, OccupancyMap& map) {
  std::ifstream file(bt_path, std::ios::binary);
  if (!file) return failure(MapIoStatus::kMissing, bt_path, "no such file");
  if (!map.read(file))
    return failure(MapIoStatus::kBroken, bt_path,
                   "no octree of this resolution with anything at the scanner's height, or too large");
  return {MapIoStatus::kOk, "loaded " + bt_path};
}

}  // namespace frontier_pilot
