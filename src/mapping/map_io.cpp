#include "frontier_pilot/mapping/map_io.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include "frontier_pilot/core/parameters.h"

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

/// What a map_server YAML says.
struct MapFile {
  std::string image;
  double resolution = 0.0;
  std::vector<double> origin;
  int negate = 0;
  double occupied_thresh = kOccupiedThreshold;
  double free_thresh = kFreeThreshold;
  std::string mode = "trinary";

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("image", image, "", "the image, relative to the YAML file");
    v.field("resolution", resolution, "m", "side of a pixel", positive());
    v.field("origin", origin, "m, m, rad", "pose of the lower left corner", anyNumber());
    v.field("negate", negate, "", "1: dark is free", between(0, 1));
    v.field("occupied_thresh", occupied_thresh, "", "darker is occupied", between(0.0, 1.0));
    v.field("free_thresh", free_thresh, "", "lighter is free", between(0.0, 1.0));
    v.field("mode", mode, "", "trinary");
  }
  void check(Problems& problems) const {
    if (image.empty()) problems.emplace_back("image: missing");
    if (!(resolution > 0.0)) problems.emplace_back("resolution: missing");
    if (origin.size() != 3) problems.emplace_back("origin: must be [x, y, yaw]");
    if (origin.size() == 3 && origin[2] != 0.0) problems.emplace_back("origin: a rotated map is not supported");
    if (mode != "trinary") problems.emplace_back("mode: only trinary is supported");
  }
};

std::int8_t valueOf(const MapFile& file, unsigned char pixel) {
  const double darkness = (file.negate != 0 ? pixel : 255 - pixel) / 255.0;
  if (darkness > file.occupied_thresh) return kOccupied;
  return darkness < file.free_thresh ? kFree : kUnknown;
}

OccupancyGrid gridOf(const MapFile& file, const cv::Mat& image) {
  GridGeometry geometry;
  geometry.resolution = file.resolution;
  geometry.origin = Vec2(file.origin[0], file.origin[1]);
  geometry.width = image.cols;
  geometry.height = image.rows;
  OccupancyGrid grid(geometry);
  for (int y = 0; y < image.rows; ++y) {
    const unsigned char* row = image.ptr(image.rows - 1 - y);
    std::transform(row, row + image.cols, grid.row(y), [&](unsigned char pixel) { return valueOf(file, pixel); });
  }
  return grid;
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

MapIoResult loadGrid(const std::string& yaml_path, OccupancyGrid& grid) {
  std::error_code error;
  if (!fs::is_regular_file(yaml_path, error)) return failure(MapIoStatus::kMissing, yaml_path, "no such file");
  MapFile file;
  try {
    const Problems problems = loadParameters(loadYamlFile(yaml_path), file);
    if (!problems.empty()) return failure(MapIoStatus::kBroken, yaml_path, problems.front());
  } catch (const std::exception& broken) {
    return failure(MapIoStatus::kBroken, yaml_path, broken.what());
  }
  const std::string image_path = (fs::path(yaml_path).parent_path() / file.image).string();
  if (!fs::is_regular_file(image_path, error)) return failure(MapIoStatus::kMissing, image_path, "no such file");
  const cv::Mat image = cv::imread(image_path, cv::IMREAD_GRAYSCALE);
  if (image.empty()) return failure(MapIoStatus::kBroken, image_path, "not an image");
  grid = gridOf(file, image);
  return {MapIoStatus::kOk, "loaded " + yaml_path};
}

MapIoResult loadOctree(const std::string& bt_path, OccupancyMap& map) {
  std::ifstream file(bt_path, std::ios::binary);
  if (!file) return failure(MapIoStatus::kMissing, bt_path, "no such file");
  if (!map.read(file)) return failure(MapIoStatus::kBroken, bt_path, "no octree of this resolution, or too large");
  return {MapIoStatus::kOk, "loaded " + bt_path};
}

}  // namespace frontier_pilot
