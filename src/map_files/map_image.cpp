#include "frontier_pilot/map_files/map_image.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <vector>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/files.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/text.h"
#include "map_files/pgm.h"

namespace frontier_pilot::map_files {
namespace {

constexpr std::size_t kMostPath = 4096;  // bytes of a path in an error
constexpr unsigned char kFreePixel = 254;
constexpr unsigned char kOccupiedPixel = 0;
constexpr unsigned char kUnknownPixel = 205;

// The keys of a map_server YAML. Without an image, a resolution or an origin it is refused.
struct MapYaml {
  std::string image;
  double resolution = 0.0;
  std::vector<double> origin;
  int negate = 0;
  double occupied_thresh = 0.65;
  double free_thresh = 0.196;
  std::string mode = "trinary";
  std::vector<double> start;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("image", image, "", "the image's file name, relative to this file");
    v.field("resolution", resolution, "m", "side of a pixel", between(bounds::kLeastPixelSize, bounds::kMostPixelSize));
    v.field("origin", origin, "m, m, rad", "pose of the lower left corner",
            between(-bounds::kMostWorldOrigin, bounds::kMostWorldOrigin));
    v.field("negate", negate, "", "1: white is occupied", between(0, 1));
    v.field("occupied_thresh", occupied_thresh, "", "darker than this is occupied", between(0.0, 1.0));
    v.field("free_thresh", free_thresh, "", "lighter than this is free", between(0.0, 1.0));
    v.field("mode", mode, "", "how grey values become cells");
    v.field("start", start, "m, m, rad", "where a robot starts by default", coordinate());
  }

  void check(Problems& problems) const {
    if (image.empty()) problems.emplace_back("image: missing");
    if (image.find('\0') != std::string::npos) problems.emplace_back("image: no file name holds a NUL character");
    if (origin.size() != 3) problems.emplace_back("origin: must be [x, y, yaw]");
    if (origin.size() == 3 && origin[2] != 0.0)
      problems.emplace_back("origin: a rotated map (yaw not 0) is not supported");
    if (free_thresh > occupied_thresh) problems.emplace_back("free_thresh: must not be above occupied_thresh");
    if (mode != "trinary" && mode != "scale" && mode != "raw")
      problems.emplace_back("mode: must be trinary, scale or raw, not '" + printable(mode, bounds::kMostReason) + "'");
    if (!start.empty() && start.size() != 3) problems.emplace_back("start: must be [x, y, yaw]");
  }
};

[[noreturn]] void fail(const std::string& file, const std::string& what) {
  throw std::runtime_error(file + ": " + what);
}

// The keys that this reader knows; the others are ignored, as by map_server. A `negate` written as true or false
// becomes a number.
ParameterMap knownKeys(ParameterMap map) {
  ParameterMap known;
  MapYaml described;
  detail::Describer describer;
  described.describe(describer);
  for (const auto& row : describer.rows) {
    const auto found = map.find(row.name);
    if (found != map.end()) known.insert(*found);
  }
  if (const auto negate = known.find("negate"); negate != known.end()) {
    if (const bool* flag = std::get_if<bool>(&negate->second.value)) negate->second.value = std::int64_t{*flag};
  }
  return known;
}

constexpr const char* kPngHead = "\x89PNG\r\n\x1a\n";

/// Whether the file is a picture in one of the usual formats, by its first bytes.
bool isImage(const std::string& path) {
  std::string head(8, '\0');
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  std::ifstream(path, std::ios::binary).read(head.data(), static_cast<std::streamsize>(head.size()));
  const bool netpbm =
      head[0] == 'P' && head[1] >= '1' && head[1] <= '6' && std::isspace(static_cast<unsigned char>(head[2])) != 0;
  return netpbm || head == kPngHead || head.rfind("\xff\xd8\xff", 0) == 0;  // the last is JPEG
}

MapYaml readYaml(const std::string& path) {
  MapYaml file;
  if (isImage(path)) {
    const std::string name = std::filesystem::path(path).filename();
    fail(path, "is a picture, and not the YAML that describes one: write a file with the lines 'image: " + name +
                   "', 'resolution: 0.05' (metres a pixel) and 'origin: [0, 0, 0]', and name that");
  }
  try {
    const ParameterMap known = knownKeys(loadYamlFile(path));
    Problems problems = loadParameters(known, file);
    if (known.count("resolution") == 0) problems.emplace_back("resolution: missing");
    std::string text;
    for (const std::string& problem : problems) text += (text.empty() ? "" : "; ") + problem;
    if (!problems.empty()) fail(path, text);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(error.what());
  }
  return file;
}

// The size in an image's header, read before the image is decoded.
struct ImageSize {
  std::uint64_t width = 0;
  std::uint64_t height = 0;
};

std::optional<ImageSize> sizeOfPng(const std::string& bytes) {
  const auto number = [&](std::size_t at) {
    std::uint64_t value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[i]);
    return value;
  };
  if (bytes.rfind(kPngHead, 0) != 0 || bytes.size() < 24 || bytes.compare(12, 4, "IHDR") != 0) return std::nullopt;
  return ImageSize{number(16), number(20)};
}

void checkSize(const ImageSize& size, double resolution, const std::string& yaml_path, const std::string& image) {
  // Each side is checked first, so that the product cannot overflow.
  const std::uint64_t longest = std::max(size.width, size.height);
  if (longest > bounds::kMostPixels || size.width * size.height > bounds::kMostPixels)
    fail(yaml_path, image + " has more than " + std::to_string(bounds::kMostPixels) + " pixels");
  if (static_cast<double>(longest) * resolution > bounds::kMostWorldSide)
    fail(yaml_path,
         image + " is longer than " + std::to_string(static_cast<int>(bounds::kMostWorldSide)) + " m on one side");
}

/// The grey values of an image, from 0 to 255.
cv::Mat decodePgm(const std::string& bytes, const PgmHeader& header) {
  cv::Mat image(static_cast<int>(header.height), static_cast<int>(header.width), CV_8U);
  return readPgm(bytes, header, image.data) ? image : cv::Mat();
}

cv::Mat decodePng(const std::string& bytes, const ImageSize& size) {
  const std::vector<char> buffer(bytes.begin(), bytes.end());
  const cv::Mat image = cv::imdecode(buffer, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
  const bool fits =
      static_cast<std::uint64_t>(image.cols) == size.width && static_cast<std::uint64_t>(image.rows) == size.height;
  return fits ? image : cv::Mat();
}

cv::Mat readImage(const std::string& yaml_path, const MapYaml& file, const std::filesystem::path& path) {
  const std::string name = "its image " + printable(path.string(), kMostPath);
  const FileContent content = readFile(path, bounds::kMostImageBytes);
  if (content.status == FileContent::Status::kMissing) fail(yaml_path, name + " does not exist");
  if (!content.ok()) fail(yaml_path, name + " cannot be read: " + content.problem);
  const std::optional<PgmHeader> pgm = pgmHeader(content.bytes);
  const std::optional<ImageSize> size = pgm ? ImageSize{pgm->width, pgm->height} : sizeOfPng(content.bytes);
  if (!size) fail(yaml_path, name + " cannot be read as PGM or PNG");
  checkSize(*size, file.resolution, yaml_path, name);
  cv::Mat image;
  try {
    image = pgm ? decodePgm(content.bytes, *pgm) : decodePng(content.bytes, *size);
  } catch (const cv::Exception& error) {
    fail(yaml_path, name + " cannot be read: " + error.what());
  }
  if (image.empty()) fail(yaml_path, name + " cannot be read as PGM or PNG: it is damaged or incomplete");
  return image;
}

/// The cell with a probability of occupation, in percent; more than 100: unknown.
std::int8_t cellOf(double percent) {
  constexpr double kLeastOccupied = 65.0;  // as in trinary mode
  constexpr double kMostFree = 25.0;
  if (percent > 100.0) return kUnknown;
  if (percent >= kLeastOccupied) return kOccupied;
  return percent <= kMostFree ? kFree : kUnknown;
}

std::int8_t cellOf(std::uint8_t pixel, const MapYaml& file) {
  if (file.mode == "raw") return cellOf(pixel);
  const double shade = (file.negate != 0 ? pixel : 255 - pixel) / 255.0;
  if (shade > file.occupied_thresh) return kOccupied;
  if (shade < file.free_thresh) return kFree;
  if (file.mode == "trinary") return kUnknown;
  return cellOf(100.0 * (shade - file.free_thresh) / (file.occupied_thresh - file.free_thresh));
}

unsigned char pixelOf(std::int8_t value) {
  if (isUnknown(value)) return kUnknownPixel;
  return isOccupied(value) ? kOccupiedPixel : kFreePixel;
}

/// The bytes of a PGM image.
class Pgm {
 public:
  explicit Pgm(const GridGeometry& geometry)
      : geometry_(geometry),
        bytes_("P5\n" + std::to_string(geometry.width) + " " + std::to_string(geometry.height) + "\n255\n"),
        header_(bytes_.size()) {
    bytes_.resize(header_ + geometry.size());
  }

  void setRow(int y, const std::int8_t* cells) {
    // An image's first row is its upper edge.
    char* row = bytes_.data() + header_ + geometry_.index({0, geometry_.height - 1 - y});
    std::transform(cells, cells + geometry_.width, row,
                   [](std::int8_t value) { return static_cast<char>(pixelOf(value)); });
  }
  std::string take() { return std::move(bytes_); }

 private:
  GridGeometry geometry_;
  std::string bytes_;
  std::size_t header_;
};

}  // namespace

MapImage readMapImage(const std::string& yaml_path, const std::string& image_path) {
  const MapYaml file = readYaml(yaml_path);
  std::filesystem::path path(image_path);
  if (path.empty()) path = std::filesystem::path(yaml_path).parent_path() / file.image;
  const cv::Mat image = readImage(yaml_path, file, path);
  MapImage read;
  read.map = OccupancyGrid(GridGeometry{file.resolution, {file.origin[0], file.origin[1]}, image.cols, image.rows});
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      read.map[Cell{x, y}] = cellOf(image.at<std::uint8_t>(image.rows - 1 - y, x), file);
    }
  }
  if (!file.start.empty()) read.start = Pose2(file.start[0], file.start[1], file.start[2]);
  return read;
}

std::string pgmOf(const OccupancyGrid& grid) {
  Pgm pgm(grid.geometry());
  for (int y = 0; y < grid.height(); ++y) pgm.setRow(y, grid.row(y));
  return pgm.take();
}

std::string pgmOf(const occupancy::OccupancyMap& map) {
  constexpr int kRows = 64;  // at a time
  const CellRect whole = map.geometry().rect();
  Pgm pgm(map.geometry());
  for (int y = 0; y < whole.height; y += kRows) {
    const OccupancyGrid rows = map.projection({0, y, whole.width, std::min(kRows, whole.height - y)});
    for (int i = 0; i < rows.height(); ++i) pgm.setRow(y + i, rows.row(i));
  }
  return pgm.take();
}

}  // namespace frontier_pilot::map_files
