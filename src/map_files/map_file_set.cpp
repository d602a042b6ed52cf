#include "map_files/map_file_set.h"

#include <cstddef>
#include <stdexcept>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/files.h"

namespace frontier_pilot::map_files {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestExtension = 5;  // .yaml

fs::path withoutExtension(const std::string& path) {
  const fs::path whole(path);
  const std::string extension = whole.extension().string();
  const bool ours = extension == ".pgm" || extension == ".yaml" || extension == ".bt";
  return ours ? fs::path(whole).replace_extension() : whole;
}

/// Whether another program has written this YAML. Throws std::invalid_argument if it cannot be parsed.
bool namesNoOctree(const std::string& yaml) {
  return compareWithYaml(yaml, SavedFile::kOctree, {}) == FileMatch::kNotMentioned;
}

/// Whether a YAML with this text mentions an octree; nothing if it cannot be parsed.
std::optional<bool> namesAnOctree(const std::string& yaml) {
  try {
    return !namesNoOctree(yaml);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace

MapIoResult failure(MapIoStatus status, const std::string& file, const std::string& what) {
  return {status, file + ": " + what};
}

MapFileSet::MapFileSet(const std::string& path) : base_(withoutExtension(path)) {}

std::string MapFileSet::nameProblem() const {
  const std::string problem = fileNameProblem(name(), kLongestExtension);
  return problem.empty() ? "" : "the map's name " + problem;
}

MapIoResult MapFileSet::compareOctree(const std::string& content) const {
  const FileContent text = readFile(yaml(), bounds::kMostYamlBytes);
  if (text.status == FileContent::Status::kMissing) return {MapIoStatus::kOk, ", not verified: it has no YAML"};
  if (!text.ok()) return failure(MapIoStatus::kBroken, yaml(), text.problem);
  try {
    switch (compareWithYaml(text.bytes, SavedFile::kOctree, content)) {
      case FileMatch::kSame:
        return {};
      case FileMatch::kNotMentioned:
        return {MapIoStatus::kOk, ", not verified: its YAML holds no checksum"};
      case FileMatch::kPrevious:
        return {MapIoStatus::kOk, ", as it was before the last save, which was not completed", true};
      case FileMatch::kAnother:
        break;
    }
  } catch (const std::invalid_argument& error) {
    return failure(MapIoStatus::kBroken, yaml(), error.what());
  }
  return failure(MapIoStatus::kBroken, octree(),
                 "is not the one that " + yaml() + " was written with: length or checksum differs");
}

bool MapFileSet::namesOctree() const {
  const FileContent text = readFile(yaml(), bounds::kMostYamlBytes);
  return text.ok() && namesAnOctree(text.bytes).value_or(false);
}

bool MapFileSet::isOfAnotherProgram() const {
  const FileContent text = readFile(yaml(), bounds::kMostYamlBytes);
  if (text.status == FileContent::Status::kMissing) return false;
  // Reading one that cannot be read as a map image reports what is wrong with it.
  return !text.ok() || !namesAnOctree(text.bytes).value_or(false);
}

std::string MapFileSet::wayOut() const {
  const FileContent text = readFile(yaml(), bounds::kMostYamlBytes);
  if (!text.ok()) return "";
  try {
    if (namesNoOctree(text.bytes) || !readFile(pictureOf(text.bytes), bounds::kMostImageBytes).ok()) return "";
  } catch (const std::invalid_argument&) {
    return "";
  }
  return "; to load the image alone, remove the entry 'octree' from " + yaml();
}

std::optional<MapFileSet::Picture> MapFileSet::otherPicture() const {
  const FileContent text = readFile(yaml(), bounds::kMostYamlBytes);
  if (!text.ok()) return {};
  try {
    const std::string picture = pictureOf(text.bytes).string();
    const FileContent image = readFile(picture, bounds::kMostImageBytes);
    if (!image.ok()) return {};
    if (namesNoOctree(text.bytes)) return Picture{picture, "its YAML names no octree"};
    const FileMatch match = compareWithYaml(text.bytes, SavedFile::kPicture, image.bytes);
    if (match == FileMatch::kAnother) return Picture{picture, "it was edited after the map was saved"};
    if (match == FileMatch::kPrevious) return Picture{picture, "it is that of the save before the last one", false};
  } catch (const std::invalid_argument&) {
  }
  return {};
}

std::optional<std::string> MapFileSet::yamlOfPictureAlone() const {
  const std::optional<Picture> other = otherPicture();
  if (!other || !other->counts) return {};
  const FileContent text = readFile(yaml(), bounds::kMostYamlBytes);
  if (!text.ok() || !namesAnOctree(text.bytes).value_or(false)) return {};
  std::string rest = withoutOctree(text.bytes);
  // Somebody may have written the entry in another way.
  return namesAnOctree(rest).value_or(true) ? std::nullopt : std::make_optional(std::move(rest));
}

fs::path MapFileSet::pictureOf(const std::string& yaml) const {
  const std::string named = imageOf(yaml);
  const std::string saved_as = savedNameOf(yaml);
  const bool renamed = saved_as != name() && named == saved_as + ".pgm";
  return renamed ? fs::path(picture()) : base_.parent_path() / named;
}

}  // namespace frontier_pilot::map_files
