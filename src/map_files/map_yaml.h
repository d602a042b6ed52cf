#pragma once

#include <optional>
#include <string>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::map_files {

/// A file that is saved beside a YAML: its content, and that of the file that it replaces, if there is one.
struct SavedContent {
  const std::string& now;
  std::optional<std::string> previous;
};

/// The YAML of a saved map in map_server's format; `name` is that of its files without an extension. In keys that
/// map_server ignores, it also holds length and checksum of the .bt and of the picture beside it, and those of the
/// files that these replace: which of the two is found later tells whether saving was completed. [MAP-5]
std::string mapYaml(const GridGeometry& geometry, const std::string& name, const SavedContent& octree,
                    const SavedContent& picture);

/// The files that a YAML holds checksums of.
enum class SavedFile { kOctree, kPicture };

/// What a YAML says about a file beside it.
enum class FileMatch {
  kSame,          ///< the YAML was written with this file
  kPrevious,      ///< the YAML was written with a file that was to replace this one
  kAnother,       ///< the YAML was written with another file
  kNotMentioned,  ///< the YAML holds no checksum of such a file: another program has written it
};

/// Compares `content` with the checksums in `yaml`. Throws std::invalid_argument if `yaml` cannot be parsed.
FileMatch compareWithYaml(const std::string& yaml, SavedFile file, const std::string& content);

/// The picture that `yaml` names, empty if it names none. Throws std::invalid_argument if `yaml` cannot be parsed.
std::string imageOf(const std::string& yaml);

/// The name under which `saveMap` wrote `yaml`; empty if another program wrote it. Throws std::invalid_argument if
/// `yaml` cannot be parsed.
std::string savedNameOf(const std::string& yaml);

/// `yaml` without its entry about the .bt.
std::string withoutOctree(const std::string& yaml);

/// Whether parsing `yaml` yields the names and the checksums that `mapYaml` was given.
bool readsAs(const std::string& yaml, const std::string& name, const std::string& octree, const std::string& picture);

}  // namespace frontier_pilot::map_files
