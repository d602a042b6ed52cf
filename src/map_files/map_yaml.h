#pragma once

#include <optional>
#include <string>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::map_files {

/// The YAML of a saved map in map_server's format; `name` is that of its files without an extension. Besides, it holds
/// length and checksum of the .bt beside it, which map_server passes over, and those of the .bt that this one takes the
/// place of: which of the two lies there tells how far saving came. [MAP-5]
std::string mapYaml(const GridGeometry& geometry, const std::string& name, const std::string& octree,
                    const std::optional<std::string>& previous);

/// What a YAML says of the .bt beside it.
enum class OctreeMatch {
  kSame,          ///< it was written with this one
  kPrevious,      ///< it was written with another one, which was to take the place of this one
  kAnother,       ///< it was written with another one
  kNotMentioned,  ///< it says nothing, as a map that did not come from here
};

/// Throws std::invalid_argument where `yaml` is none.
OctreeMatch compareOctree(const std::string& yaml, const std::string& octree);

/// Whether a reader would find in `yaml` the image and the .bt that `mapYaml` was told.
bool readsAs(const std::string& yaml, const std::string& name, const std::string& octree);

}  // namespace frontier_pilot::map_files
