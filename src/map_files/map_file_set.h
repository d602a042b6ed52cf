#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "frontier_pilot/map_files/map_io.h"
#include "map_files/map_yaml.h"

namespace frontier_pilot::map_files {

/// A failure that says what is wrong with `file`.
MapIoResult failure(MapIoStatus status, const std::string& file, const std::string& what);

/// The files of a saved map, which have the same name and different extensions.
class MapFileSet {
 public:
  /// `path` may end in the extension of one of the files.
  explicit MapFileSet(const std::string& path);

  /// The folder of the files.
  std::filesystem::path folder() const { return base_.has_parent_path() ? base_.parent_path() : "."; }
  const std::filesystem::path& base() const { return base_; }
  std::string name() const { return base_.filename().string(); }
  std::string yaml() const { return base_.string() + ".yaml"; }
  std::string octree() const { return base_.string() + ".bt"; }
  std::string picture() const { return base_.string() + ".pgm"; }
  /// What is wrong with the name; empty if nothing is. It does not quote the name: what makes one unacceptable (control
  /// characters) would also harm a log.
  std::string nameProblem() const;

  /// Whether the .bt, whose content is `octree`, was written with the YAML, if there is one. If that is not certain,
  /// the text says so.
  MapIoResult compareOctree(const std::string& octree) const;
  /// Whether there is a YAML that can be read and mentions an octree.
  bool namesOctree() const;
  /// Whether there is a YAML that mentions no octree, as other programs write it, or one that cannot be read. A YAML
  /// that `saveMap` wrote and whose .bt is missing belongs to a damaged map.
  bool isOfAnotherProgram() const;
  /// How a map is loaded whose octree is damaged, as the end of an answer; empty if that would not help.
  std::string wayOut() const;
  /// A picture that was not saved with the octree, and where it is from.
  struct Picture {
    std::string path;
    std::string why;
    bool counts = true;  ///< it is loaded instead of the octree
  };
  /// The picture, if it is another one than was saved with the octree. It counts if somebody has edited it, or named
  /// another in the YAML, or another program has saved its map under the same name. That of the save before does not:
  /// the last save was not completed, or somebody has put it back.
  std::optional<Picture> otherPicture() const;
  /// The YAML's text without its entry `octree`, if that is there and the picture counts all the same: with this text
  /// the picture counts whatever the .bt is.
  std::optional<std::string> yamlOfPictureAlone() const;

 private:
  /// The picture that belongs to the map whose YAML has this text. The YAML of a map that was renamed or copied with
  /// its files still names the picture of before, which may be that of another map by now: it is the one beside it
  /// then.
  std::filesystem::path pictureOf(const std::string& yaml) const;

  std::filesystem::path base_;
};

}  // namespace frontier_pilot::map_files
