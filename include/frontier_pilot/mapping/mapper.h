#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/core/time.h"
#include "frontier_pilot/localization/map_localization.h"
#include "frontier_pilot/mapping/mapping_health.h"
#include "frontier_pilot/mapping/scan_verdict.h"
#include "frontier_pilot/occupancy/occupancy_map.h"
#include "frontier_pilot/occupancy/scan_inserter.h"
#include "frontier_pilot/slam/graph_slam.h"
#include "frontier_pilot/slam/pose_correction.h"

namespace frontier_pilot::mapping {

struct MapperParameters {
  RobotModel robot;              ///< it stands on free floor; described by the node
  double max_age = 1.0;          ///< an older scan is stale [s]
  double max_lead = 0.5;         ///< a scan may be this much ahead of the clock [s]
  double min_travel = 0.01;      ///< a robot that moved less has not moved [m]
  double min_rotation = 0.01;    ///< a robot that turned less has not turned [rad]
  double standing_period = 0.2;  ///< time between scans used while the robot stands [s]
  bool trust_odometry = false;   ///< take odometry for the truth: no matching, no loops
  bool localize_only = false;    ///< leave the map as it was loaded; described by the node
  occupancy::OccupancyMapParameters map;
  occupancy::ScanInsertionParameters insertion;
  slam::GraphSlamParameters slam;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("max_age", max_age, "s", "an older scan is stale", timeSpan());
    v.fixed({"max_lead"});
    v.field("min_travel", min_travel, "m", "a robot that moved less since the last scan stands", atLeast(0.0));
    v.fixed({"min_rotation", "standing_period"});
    v.field("trust_odometry", trust_odometry, "", "take odometry for the truth: no scan matching, no loop closing");
    v.group("map", map, "the map and its octree");
    v.group("insertion", insertion, "how a scan goes into the map");
    v.group("slam", slam, "scan matching and loop closing");
  }
};

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

  /// Puts `scan`, taken at `T_odom_base`, into the map, or says why not; no pose: there is no odometry for its stamp.
  /// Of more than bounds::kMostMappedBeams beams every n-th is used. [FLT-1]
  ScanVerdict insert(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now);

  /// Work for another thread, if there is some; none while the last one's result has not come back.
  slam::RevisionWork takeWork();
  /// Takes over what the work came to; `revision` then holds what is no longer needed. Scans that came meanwhile are
  /// put into a map that was rendered anew. A map that is too large is refused, and then poses stay as well: `health`
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
  const OccupancyGrid& grid() const { return map_.grid(); }
  occupancy::OccupancyMap& map() { return map_; }
  const occupancy::OccupancyMap& map() const { return map_; }
  /// What changed in `grid` since the last call.
  occupancy::MapChanges takeChanges() { return map_.takeChanges(); }
  const Pose2& T_map_odom() const { return T_map_odom_; }
  const ScanCounts& counts() const { return counts_; }
  const RevisionReport& revisions() const { return revisions_; }
  /// How often each way to find a scan's pose was taken, and the last one.
  const std::map<std::string, std::uint64_t>& correctionCounts() const { return correction_counts_; }
  const char* lastCorrection() const { return last_correction_; }
  /// Share of the last scan's beams that tell where there is something, or nothing; 1 before the first.
  double usableShare() const { return usable_share_; }
  /// What has been remarkable about the scans of the last seconds.
  const MappingHealth& health() const { return health_; }
  /// The keyframes so far, each where it is by what is known now. Not while work is out.
  std::vector<slam::KeyframePose> trajectory() const { return correction_->trajectory(); }

  /// Forgets the map and the correction; the geometry and the counts stay.
  void reset();

 private:
  struct Last {
    Time stamp;
    Pose2 T_odom_base;
  };
  struct Inserted {
    LaserScan2 scan;
    Pose2 T_map_base;
  };

  void note(ScanVerdict verdict, Time now);
  ScanVerdict decide(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now);
  ScanVerdict integrate(const LaserScan2& scan, const Pose2& T_odom_base);
  bool isTooLarge(const slam::MapRevision& revision) const;
  bool refuse(slam::MapRevision& revision);
  scan_matching::PoseWithCovariance presentBelief() const;
  void replace(std::unique_ptr<slam::PoseCorrection> correction);
  ScanVerdict put(const LaserScan2& scan, const Pose2& T_map_base);
  std::optional<ScanVerdict> checkStamp(Time stamp, Time now);
  bool hasMoved(const LaserScan2& scan, const Pose2& T_odom_base) const;

  MapperParameters parameters_;
  occupancy::OccupancyMap map_;
  occupancy::ScanInserter inserter_;
  std::unique_ptr<slam::PoseCorrection> correction_;
  Pose2 T_map_odom_;
  Time now_{};
  std::optional<Last> last_;  ///< the last scan that was placed
  ScanCounts counts_;
  std::uint64_t epoch_ = 0;  ///< one for each corrector: work for an earlier one is void
  bool working_ = false;
  std::vector<Inserted> meanwhile_;  ///< what went into the map while work is out
  RevisionReport revisions_;
  std::map<std::string, std::uint64_t> correction_counts_;
  const char* last_correction_ = "";
  bool sound_ = true;              ///< the last correction was
  bool overgrown_ = false;         ///< the last revision's map would have been larger than a map may be
  std::size_t out_of_bounds_ = 0;  ///< scans that the map had no room for
  double usable_share_ = 1.0;
  MappingHealth health_;
};

}  // namespace frontier_pilot::mapping
