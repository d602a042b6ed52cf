#pragma once

#include <filesystem>
#include <string>

/// The files of a map that is kept for the next mapper. `base` is their common path without the endings: the name of
/// the session's folder, and in it that of the node.
namespace frontier_pilot::kept_map {

bool exists(const std::filesystem::path& base);
void removeFiles(const std::filesystem::path& base);
/// Removes the maps that the same node has left in other sessions, but for the three newest.
void removeOldest(const std::filesystem::path& own);
/// Moves a map that cannot be continued with to the folder `lost` beside it, in place of one that is there. Returns its
/// new base; empty if it could not be moved.
std::string setAside(const std::filesystem::path& base);

}  // namespace frontier_pilot::kept_map
