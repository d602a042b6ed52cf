#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/localization/map_localization.h"
#include "frontier_pilot/mapping/parameters.h"
#include "frontier_pilot/occupancy/occupancy_map.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "frontier_pilot/slam/pose_correction.h"

namespace frontier_pilot::mapping {

/// What became of a scan. [MAP-4]
enum class ScanVerdict {
  kInserted,     ///< it is in the map
  kLocalized,    ///< it was used to localize the robot; the map stays as it is
  kNotMoved,     ///< the robot has not moved since the last one, and not enough time has passed
  kNoTransform,  ///< the pose of the scanner on the base is not known
  kNoOdometry,   ///< there is no odometry for its stamp
  kStale,        ///< its stamp is too old, or not newer than the last one's
  kFuture,       ///< its stamp lies ahead of the clock
  kWrongFrame,   ///< its frame is empty or not allowed
  kMalformed,    ///< its geometry is not finite or not that of a scan, or it has no ranges
  kAllInvalid,   ///< no beam is usable
  kOutOfBounds,  ///< the map would become too large
  kTooFar,       ///< farther from the map's origin than a map reaches
  kMisfit,       ///< it fits nowhere near, and would only corrupt the map
  kNotLocated,   ///< the robot is sought on a known map, and the scan does not fit where it is said to be
  kBlind,        ///< it has hardly any return where the map has walls all around
};
constexpr std::size_t kScanVerdicts = 15;

const char* toString(ScanVerdict verdict);

/// Whether the scan was lost to an error, rather than used or superfluous.
inline bool isDropped(ScanVerdict verdict) {
  return verdict != ScanVerdict::kInserted && verdict != ScanVerdict::kLocalized && verdict != ScanVerdict::kNotMoved;
}

/// A problem that many of the scans of the last seconds had in common.
struct ScanRemark {
  std::string text;
  double share = 0.0;  ///< of these scans, 0 ... 1
};

/// The number of scans by verdict.
class ScanCounts {
 public:
  void add(ScanVerdict verdict) { ++counts_[static_cast<std::size_t>(verdict)]; }
  std::uint64_t operator[](ScanVerdict verdict) const { return counts_[static_cast<std::size_t>(verdict)]; }
  /// How many were lost to an error.
  std::uint64_t dropped() const;

 private:
  std::array<std::uint64_t, kScanVerdicts> counts_{};
};

/// What revisions have changed so far.
struct RevisionReport {
  std::uint64_t closures = 0;    ///< loops closed; a revision without a new one leaves `T_map_odom` as it is
  std::uint64_t rendered = 0;    ///< how often the map was rendered again
  slam::ClosureCounts attempts;  ///< to close loops
  Pose2 last_jump;               ///< T_new_old of the last closures: how they moved the robot in the map
  std::vector<slam::LoopClosure> last_closures;
};

/// The result of a search of the whole map for the robot.
struct RobotSearch {
  bool found() const { return result.verdict == localization::SearchVerdict::kFound; }

  localization::WholeMapSearch result;
  Pose2 T_odom_base;             ///< of the last scan, whose pose in the map the result tells
  std::uint64_t generation = 0;  ///< of the map that was searched: one that was replaced or corrected has another one
};

/// Builds the map from scans and the odometry at their stamps. Whatever is wrong with a scan, what is already mapped
/// stays. [MAP-4]
/// Revising past poses takes time: the owner of the mapper either runs the work from `takeWork` in the background and
/// passes its result to `revise`, or calls `reviseNow` after each scan.
class Mapper {
 public:
  /// Without `correction` the parameters determine one.
  explicit Mapper(const MapperParameters& parameters = {}, std::unique_ptr<slam::PoseCorrection> correction = nullptr);
  ~Mapper();
  Mapper(Mapper&&) noexcept;
  Mapper& operator=(Mapper&&) noexcept;
  Mapper(const Mapper&) = delete;
  Mapper& operator=(const Mapper&) = delete;

  /// Inserts `scan`, taken at `T_odom_base`, into the map, or returns why not; no pose: there is no odometry for its
  /// stamp. Of more than bounds::kMostMappedBeams beams every n-th is used. [FLT-1]
  ScanVerdict insert(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now);

  /// Work for another thread, if there is any; none until the result of the last work has been passed to `revise`, and
  /// none after `abandonWork` until a reset.
  slam::RevisionWork takeWork();
  /// Takes over the result of the work; `revision` then holds the replaced map. Scans that arrived meanwhile are
  /// inserted into a newly rendered map. A map that is too large is refused, and the poses then stay as they are too:
  /// `remark` says so until one fits. Returns false, and does nothing, when the mapper has been reset, been given a map
  /// or been located since.
  bool revise(slam::MapRevision& revision);
  /// The work taken last threw: the map stays as it is, and mapping continues without revisions until a reset.
  /// Returns false, and does nothing, when no work is under way, as after a reset.
  bool abandonWork();
  /// Whether that is so: mapping continues without revisions until a reset, a loaded map or a given pose.
  bool hasAbandonedWork() const;
  /// Runs the work that there is, and takes its result over, before it returns.
  void reviseNow();

  /// Swaps the map with `loaded`; the following scans look for the robot around the present estimate of its pose. On a
  /// map without walls it cannot be found, and counts as being there. Returns false, and does nothing, when a map that
  /// covers both would be too large.
  bool load(occupancy::OccupancyMap& loaded);
  /// Continues with an earlier map, in which the odometry frame was at `T_map_odom`; odometry now has the robot at
  /// `T_odom_base`. The following scans look for the robot there, unless odometry is trusted and `was_localized`:
  /// whether the mapper that left the map had the robot localised. On a map without walls the robot is not looked for,
  /// and counts as being there. Returns false, and does nothing, when the map would be too large.
  bool resume(occupancy::OccupancyMap& map, const Pose2& T_map_odom, const Pose2& T_odom_base, bool was_localized);
  /// Takes the present map as known; the following scans look for the robot around `T_map_base`. Returns false, and
  /// does nothing, when it cannot be found there, see `whyNotFound`.
  bool locate(const scan_matching::PoseWithCovariance& T_map_base);

  /// Why the robot cannot be found on the present map, for the operator; empty if it can.
  std::string whyNotFound() const;

  /// Work for another thread: looks for the robot all over the present map, by the scans of the last metres, until
  /// `stop` is true, which it then has to stay.
  std::function<RobotSearch()> searchWork(const std::function<bool()>& stop = {}) const;
  /// Goes on from where the search has found the robot, which may have driven on since, as from an estimate of its
  /// pose. Returns false, and does nothing, when it was not found, or when the mapper has been reset or been given a
  /// map or has corrected its own since `searchWork`, or its clock was set back, or the map is too large by now.
  bool locate(const RobotSearch& search);
  /// The number of the map, for `RobotSearch`.
  std::uint64_t generation() const;

  /// Counts a scan that was rejected before it could be passed to `insert`.
  void reject(ScanVerdict verdict, Time now);

  /// The map's projection; empty until the first scan. See OccupancyMap::grid for what it costs.
  const OccupancyGrid& grid() const { return map().grid(); }
  occupancy::OccupancyMap& map();
  const occupancy::OccupancyMap& map() const;
  /// What changed in `grid` since the last call.
  occupancy::MapChanges takeChanges() { return map().takeChanges(); }
  const Pose2& T_map_odom() const;
  /// Whether the robot is where `T_map_odom` has it, as far as scans can tell. False from when it is looked for on a
  /// map, loaded or kept by a mapper that died, until a scan fits there; while it seems to have been carried; and, in a
  /// map that stays as it is, instead when it has driven 2 m without a scan that fits. [MAP-5]
  bool isLocalized() const;
  const ScanCounts& counts() const;
  const RevisionReport& revisions() const;
  /// How the poses of scans were found: how often each way, and the last one.
  const std::map<std::string, std::uint64_t>& correctionCounts() const;
  const char* lastCorrection() const;
  /// Share of the last scan's beams with a return or free up to range_max; 1 before the first scan.
  double usableShare() const;
  /// The most frequent problem with the scans of the last seconds, if it was not just a few of them.
  std::optional<ScanRemark> remark(Time now) const;
  /// The keyframes so far, at their presently estimated poses. Must not be called while work is under way.
  std::vector<slam::KeyframePose> trajectory() const;
  /// How many keyframes are kept, each with what its scan saw: they are the part of the mapper's memory that grows with
  /// the way driven, until a reset, a loaded map or a given pose.
  std::size_t keyframes() const;

  /// Forgets the map and the correction; the grid's size and origin and the counts stay.
  void reset();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::mapping
