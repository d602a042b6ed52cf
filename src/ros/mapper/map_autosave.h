#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/occupancy/occupancy_map.h"
#include "ros/common/memory/memory_report.h"
#include "ros/common/memory/session_memory.h"
#include "ros/common/messages/mailbox.h"
#include "ros/mapper/kept_map.h"
#include "ros/mapper/save_schedule.h"

namespace frontier_pilot {

/// How far a map has come.
struct MapContent {
  std::uint64_t scans;     ///< that were inserted
  std::uint64_t rendered;  ///< how often it was rendered again, after which the robot is elsewhere on it
};

/// Where the copy is that a mapper leaves at its end.
struct LeftCopy {
  std::string base;               ///< of its files; empty if there is no copy
  bool is_being_written = false;  ///< an older one is there until that has ended, or none
};

/// Keeps a copy of the map for a mapper that is restarted in the same ROS session after it died: the map is saved
/// periodically under ROS_HOME, with the transform `map -> odom`, and removed when the mapper is shut down regularly.
/// At most three maps of earlier sessions are kept. If the map is replaced, by one that is loaded or by a reset, while
/// the disk does not answer or cannot be written, that is recorded in memory, and a mapper that is started then does
/// not continue with the map before it. [FLT-2]
class MapAutosave {
 public:
  /// `map_file` is the parameter: the map that this mapper begins with.
  explicit MapAutosave(const std::string& map_file);

  /// What the mapper that died began with, if that is not what this one begins with: a `map_file`, or empty for none.
  /// Its map then belongs to another launch. Nothing if it is the same, or not known.
  std::optional<std::string> otherMapFile() const;
  /// Moves the copy that is there to the folder `lost` (`kept_map::setAside`), and forgets its pose. Returns its new
  /// base; empty if it could not be moved.
  std::string putAside();
  /// The same at the end, because the map was not saved elsewhere; a copy that could not be moved, or is still being
  /// written, stays where it is. Nothing if the disk does not answer in time.
  std::optional<LeftCopy> leave(Duration patience);
  /// Reads the map of a mapper that died and returns its pose; nothing if there is none. Throws
  /// std::runtime_error with the reason if there is one that cannot be read.
  std::optional<MapPose> restore(occupancy::OccupancyMap& map) const;
  /// Runs a job on a thread that may wait for the disk.
  using Run = std::function<void(std::function<void()>)>;
  /// Saves `map` by `run`. A map is not saved if it has not changed (`has` counts its changes),
  /// while an earlier one is still being saved, and so soon after it that saving would take more than a twentieth of
  /// the time (SaveSchedule); the pose is kept each time.
  void save(occupancy::OccupancyMap& map, const MapPose& pose, MapContent has, const Run& run);
  /// The next map is saved however soon after the one before it, because it may be the last one.
  void hurry() { noteEnd(), schedule_.hurry(); }
  /// Whether the save that was begun last has not ended yet.
  bool isSaving() const { return ended_ && !*ended_; }
  /// Why the map that was to be saved last would not survive; empty if it would. If it would not, a mapper that is
  /// started after this call does not continue with the map before it either.
  std::string whyNotSaved();
  /// Keeps `pose` beside the copy that there is, without saving the map. If the map was rendered again since, the
  /// pose of the copy stays as it is, as that of a mapper that lives.
  void remember(const MapPose& pose, std::uint64_t rendered);
  /// Removes the copy, because the map was reset or the mapper is shut down regularly. The next map is saved whatever
  /// its `content`, and as soon as it can be. Waits at most `patience` for a disk that hangs; later on the copy is
  /// removed before anything is saved. Returns why it would come back with the next mapper; empty if it would not.
  std::string forget(Duration patience = std::chrono::milliseconds(500));
  /// Whether the copy is still to be removed, because the disk has not answered yet.
  bool isForgetting() const { return unwanted_.has_value(); }
  /// The same, because another map was loaded; but the copy stays until that map replaces it, so that a mapper which
  /// dies meanwhile leaves one of the two. If that map cannot be saved, the copy is moved to the folder `lost`.
  void supersede();
  /// Records that the map of the mapper that died cannot be continued with, and moves its files to the folder `lost`
  /// beside them (`kept_map::setAside`). It is reported until the map is reset or loaded, or for a
  /// minute after the first scan of the new map: an error that never goes away would soon be ignored.
  void lose(const std::string& why);
  /// Why the map of the mapper that died is lost, and where its files are; empty if it is not.
  const std::string& loss() const { return loss_; }
  /// Reports what would be lost with this node, and what was lost with the one before it. Returns the problem() that
  /// counts.
  std::string tell(MemoryReport& report) const;
  /// Why the last map or pose could not be saved; empty if they were.
  const std::string& problem() const { return problem_.empty() ? pose_problem_ : problem_; }
  /// Changes to the ROS session with these names.
  void enter(const std::vector<std::string>& sessions);

 private:
  MapAutosave(const std::string& map_file, const std::vector<std::string>& sessions);

  struct Saved {
    std::string problem;
    SteadyTime at;
    Duration took;
    std::uint64_t rendered;
  };

  /// The base name of the copy's files; nothing if there is none.
  std::optional<std::filesystem::path> find() const;
  /// What is remembered beside the copy; nothing if it cannot be read.
  std::optional<KeptPose> recall() const;
  std::string keptBefore() const;
  /// Takes over how the save has ended that was begun last.
  void noteEnd();
  std::string textOf(const MapPose& pose) const { return toText({pose, map_file_}); }
  std::string moveAside();
  /// Removes the copy that was given up. Returns why it could not be; nothing if the disk does not answer.
  std::optional<std::string> discardUnwanted();
  void noteMapping(std::uint64_t content, SteadyTime now);

  const std::string map_file_;
  SessionMemory memory_;                        ///< holds a KeptPose; the map's files lie beside it
  SessionMemory replaced_;                      ///< holds, not on a disk, that the copy is of a map that was replaced
  std::optional<SessionMemory> unwanted_;       ///< the place of a copy that is to be removed
  std::shared_ptr<std::atomic<bool>> wanted_;   ///< false once the copy being saved is obsolete
  std::shared_ptr<std::atomic<bool>> current_;  ///< false once the map being saved was replaced
  std::shared_ptr<SavedPose> saved_pose_;       ///< of the map that is being saved, unless it was replaced
  std::shared_ptr<Mailbox<Saved>> done_;
  std::shared_ptr<std::atomic<bool>> ended_;  ///< whether the save that was begun last has
  SaveSchedule schedule_;
  bool superseded_ = false;                  ///< the copy on disk, if any, is of the map before the one that was loaded
  std::uint64_t rendered_ = 0;               ///< how often the map of the copy had been rendered again
  std::string problem_, pose_problem_;       ///< why the last map, and the last pose, could not be saved
  std::string loss_;                         ///< why the map of the mapper that died is lost
  std::optional<SteadyTime> mapping_since_;  ///< when the first scan came into the new map
};

}  // namespace frontier_pilot
