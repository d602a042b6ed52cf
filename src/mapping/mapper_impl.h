#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/motion.h"
#include "frontier_pilot/grids/ray_casting.h"
#include "frontier_pilot/mapping/mapper.h"
#include "frontier_pilot/occupancy/scan_inserter.h"
#include "mapping/localization_watch.h"
#include "mapping/mapping_health.h"
#include "mapping/recent_scans.h"

namespace frontier_pilot::mapping {

/// What the mapper consists of: scans and revisions in mapper.cpp, known maps and where the robot is on them in
/// mapper_known_map.cpp.
struct Mapper::Impl {
  struct Inserted {
    surfaces::SurfaceScan scan;
    Pose2 T_map_base;
  };

  Impl(const MapperParameters& given, std::unique_ptr<slam::PoseCorrection> corrector);

  void note(ScanVerdict verdict, Time now);
  ScanVerdict decide(const LaserScan2& scan, const std::optional<Pose2>& T_odom_base, Time now);
  ScanVerdict take(const LaserScan2& scan, const Pose2& T_odom_base);
  ScanVerdict integrate(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base);
  ScanVerdict put(const surfaces::SurfaceScan& scan, const Pose2& T_map_base);
  std::optional<ScanVerdict> checkStamp(Time stamp, Time now);
  bool hasMoved(const LaserScan2& scan, const Pose2& T_odom_base) const;
  bool isTooLarge(const slam::MapRevision& revision) const;
  bool refuse(slam::MapRevision& revision);
  /// From now on the map is known, and the robot is looked for around `T_map_base`, and from there on by odometry since
  /// `T_odom_base`; if that is not known, since the first scan.
  void lookFor(const scan_matching::PoseWithCovariance& T_map_base, const std::optional<Pose2>& T_odom_base);
  void replace(std::unique_ptr<slam::PoseCorrection> corrector);
  void forgetEarlierPoses();

  MapperParameters parameters;
  occupancy::OccupancyMap map;
  occupancy::ScanInserter inserter;
  std::unique_ptr<slam::PoseCorrection> correction;
  Pose2 T_map_odom;
  Time last_now{};
  std::optional<StampedPose2> last;  ///< T_odom_base of the last scan that was placed
  ScanCounts counts;
  std::uint64_t epoch = 0;       ///< number of the corrector: work of an earlier one is void
  std::uint64_t generation = 0;  ///< number of the map and its rendering: a search of an earlier one is void
  bool working = false, abandoned = false;
  std::vector<Inserted> meanwhile;  ///< scans inserted into the map while work is under way
  RevisionReport revisions;
  std::map<std::string, std::uint64_t> correction_counts;
  const char* last_correction = "";
  bool sound = true;              ///< whether the last correction was sound
  bool overgrown = false;         ///< the last map of a revision was refused because it was too large
  std::size_t out_of_bounds = 0;  ///< scans that the map had no room for
  double usable_share = 1.0;
  MappingHealth health;
  RecentScans recent;
  LocalizationWatch localization;
  grids::BlindnessCheck blindness;
};

}  // namespace frontier_pilot::mapping
