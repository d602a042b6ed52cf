#pragma once

#include <optional>
#include <string>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::map_files {

/// The YAML of a saved map in map_server's format; `name` is that of its files without an extension. In keys that
/// map_server ignores, it also holds length and checksum of the .bt beside it, and those of the .bt that this one
/// replaces: which of the two is found later tells whether saving was completed. [MAP-5]
std::string mapYaml(const GridGeometry& geometry, const std::string& name, const std::string& octree,
                    const std::optional<std::string>& previous);

/// What a YAML says about the .bt beside it.
enum class OctreeMatch {
  kSame,          ///< the YAML was written with this .bt
  kPrevious,      ///< the YAML was written with a .bt that was to replace this one
  kAnother,       ///< the YAML was written with another .bt
  kNotMentioned,  ///< the YAML mentions no .bt: another program has written it
};

/// Throws std::invalid_argument if `yaml` cannot be parsed.
OctreeMatch compareOctree(const std::string& yaml, const std::string& octree);

/// Whether parsing `yaml` yields the names and the checksum that `mapYaml` was given.
bool readsAs(const std::string& yaml, const std::string& name, const std::string& octree);

}  // namespace frontier_pilot::map_files
