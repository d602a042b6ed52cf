#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "ros/common/memory/session_memory.h"

/// The files of a map that is kept for the next mapper. `base` is their common path without the endings: the name of
/// the session's folder, and in it that of the node.
namespace frontier_pilot::kept_map {

/// Whether at least one of its files is there.
bool exists(const std::filesystem::path& base);
void removeFiles(const std::filesystem::path& base);
/// Removes the maps that the same node has left in other sessions, but for the three newest and that of a mapper which
/// runs, and files that were left unfinished more than ten minutes ago.
void removeOldest(const std::filesystem::path& own);
/// Moves what there is of a map that cannot be continued with to the folder `lost` beside it or, if one is there
/// already or nothing can be written there, to `lost.2` and so on, up to `lost.9`; a map in that one is replaced,
/// because those that were lost first are more likely to be worth something. Returns its new base; empty if it could
/// not be moved.
std::string setAside(const std::filesystem::path& base);
/// What an operator should know of a map that was moved to `lost`: how it is loaded, and, in the last folder, that each
/// one replaces the one before it.
std::string whereItIs(const std::string& lost);
/// Gives files in which poses are remembered the time of now, as if they were written again. Returns what went wrong;
/// empty if nothing did.
std::string renew(const std::vector<std::filesystem::path>& poses);
/// The base of the map that was put aside last; empty if none is there.
std::string lastSetAside(const std::filesystem::path& base);
/// Stores what belongs to a map by `attempt`, which returns what went wrong, on a thread that may wait for a disk which
/// is busy for a moment: again and again for two seconds. Returns what went wrong at last; empty if nothing did.
std::string tryForAWhile(const std::function<std::string()>& attempt);

}  // namespace frontier_pilot::kept_map

namespace frontier_pilot {

/// Where odometry is on a map, and whether the robot is there, as far as scans can tell.
struct MapPose {
  Pose2 T_map_odom;
  bool localized = false;  ///< false as well in a copy that an earlier version left
};

/// What is remembered beside the map that is kept for the next mapper.
struct KeptPose : MapPose {
  /// The map that its mapper began with, as `mapFileName` tells it; nothing in a copy that an earlier version left.
  std::optional<std::string> map_file;
};

/// The parameter `map_file` as a whole path that can stand in a line; empty if there is none.
std::string mapFileName(const std::string& map_file);
/// One line with all digits, so that exactly the same pose is read back.
std::string toText(const KeptPose& pose);
/// Nothing if it is no pose, or one that no robot can have.
std::optional<KeptPose> toKeptPose(const std::string& text);

/// The pose that is kept with a map while that is being saved: the one with which saving began, or a newer one on the
/// same map. Safe to use from several threads.
class SavedPose {
 public:
  /// `rendered` says how often the map was rendered again.
  SavedPose(std::string text, std::uint64_t rendered) : rendered_(rendered), text_(std::move(text)) {}

  /// Takes a newer pose, unless it is one on the map after that was rendered again.
  void renew(const std::string& text, std::uint64_t rendered) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (rendered == rendered_) text_ = text;
  }
  /// Stores the newest pose, before any that is stored after renew(). Returns what went wrong; empty if nothing did.
  std::string keepIn(const SessionMemory& memory) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return memory.remember(text_);
  }

 private:
  const std::uint64_t rendered_;
  mutable std::mutex mutex_;
  std::string text_;
};

}  // namespace frontier_pilot
