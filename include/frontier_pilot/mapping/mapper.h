#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/mapping/parameters.h"
#include "frontier_pilot/mapping/scan_verdict.h"
#include "frontier_pilot/occupancy/occupancy_map.h"
#include "frontier_pilot/scan_matching/scan_matcher.h"
#include "frontier_pilot/slam/pose_correction.h"

namespace frontier_pilot::mapping {

/// What revisions have come to so far.
struct RevisionReport {
  std::uint64_t closures = 0;    ///< loops closed: `T_map_odom` jumps with these, and with nothing else
  std::uint64_t rendered = 0;    ///< how often the map was rendered again
  slam::ClosureCounts attempts;  ///< of closing loops
  Pose2 last_jump;               ///< by what the last closures have moved the robot in the map
  std::vector<slam::LoopClosure> last_closures;
};

/// Builds the map from scans and the odometry of the moment each was taken at. Whatever is wrong with a scan, what is
/// already mapped stays. [MAP-4]
/// Revising the past takes time: whoever owns the mapper does `takeWork` in the background and hands the
/// result to `revise`, or calls `reviseNow` after each scan.
class Mapper {
 public:
  /// Without a corrector the parameters choose one.
  explicit Mapper(const MapperParameters& parameters = {}, std::unique_ptr<slam::PoseCorrection> correction = nullptr);
  ~Mapper();
  Mapper(Mapper&&) noexcept;
  Mapper& operator=(Mapper&&) noexcept;
  Mapper(const Mapper&) = delete;
  Mapper& operator=(const Mapper&) = delete;

  /// Puts `scan`, taken at `T_odom_base`, into the map, or says why not; no pose: there is no odometry for its stamp.
  /// Of more than bounds::kMostMappedBeams beams every n-th is used. [FLT-1]
  ScanVerdict insert(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now);

  /// Work for another thread, if there is some; none while the last one's result has not come back.
  slam::RevisionWork takeWork();
  /// Takes over what the work came to; `revision` then holds what is no longer needed. Scans that came meanwhile are
  /// put into a map that was rendered anew. A map that is too large is refused, and then poses stay as well: `remark`
  /// says so until one fits. False, and nothing happens, when the mapper was reset since.
  bool revise(slam::MapRevision& revision);
  /// The work taken last threw: the map stays as it is, and mapping goes on without revisions until a reset.
  /// False, and nothing happens, when the mapper was reset since.
  bool abandonWork();
  /// Does all work there is at once.
  void reviseNow();

  /// Puts `loaded` in the place of the map and looks for the robot in it, about where it is thought to be. False, and
  /// nothing happens, when the two together would be too large.
  bool load(occupancy::OccupancyMap& loaded);
  /// Goes on with a map that was made before, by a robot that odometry now has at `T_odom_base`. False, and nothing
  /// happens, when the map would be too large.
  bool resume(occupancy::OccupancyMap& map, const Pose2& T_map_odom, const Pose2& T_odom_base);
  /// The robot is about at `T_map_base`: takes the map as it is for known, looks for the robot there, and goes on.
  /// False, and nothing happens, when the map shows nothing that could be recognised.
  bool locate(const scan_matching::PoseWithCovariance& T_map_base);

  /// Counts a scan that could not even be offered.
  void reject(ScanVerdict verdict, Time now);

  /// The map's projection; empty until the first scan.
  const OccupancyGrid& grid() const { return map().grid(); }
  occupancy::OccupancyMap& map();
  const occupancy::OccupancyMap& map() const;
  /// What changed in `grid` since the last call.
  occupancy::MapChanges takeChanges() { return map().takeChanges(); }
  const Pose2& T_map_odom() const;
  const ScanCounts& counts() const;
  const RevisionReport& revisions() const;
  /// How often each way to find a scan's pose was taken, and the last one.
  const std::map<std::string, std::uint64_t>& correctionCounts() const;
  const char* lastCorrection() const;
  /// Share of the last scan's beams that tell where there is something, or nothing; 1 before the first.
  double usableShare() const;
  /// What went wrong most often with the scans of the last seconds, if it was more than a slip.
  std::optional<ScanRemark> remark(Time now) const;
  /// The keyframes so far, each where it is by what is known now. Not while work is out.
  std::vector<slam::KeyframePose> trajectory() const;

  /// Forgets the map and the correction; the geometry and the counts stay.
  void reset();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::mapping
