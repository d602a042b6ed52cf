#pragma once

#include "frontier_pilot/scan_matching/likelihood_grid.h"
#include "frontier_pilot/scan_matching/surfel_map.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::scan_matching {

/// What scans are matched with: a likelihood field to search in, and surfels to refine on, of the same points.
class SurfaceMap {
 public:
  explicit SurfaceMap(const LikelihoodParameters& parameters = {}) : likelihood_(parameters) {}

  /// `points` at `T_map_points`; dense, see `filled`.
  void add(const surfaces::SurfacePoints& points, const Pose2& T_map_points);
  /// As `add`, but for the surfels only: what is known well becomes known better, nothing is found that was not.
  void updateKnown(const surfaces::SurfacePoints& points, const Pose2& T_map_points) {
    surfels_.updateKnown(points, T_map_points);
  }

  const LikelihoodGrid& likelihood() const { return likelihood_; }
  const SurfelMap& surfels() const { return surfels_; }
  bool empty() const { return likelihood_.grid().empty(); }
  /// [bytes]
  std::size_t memory() const { return likelihood_.grid().size() + surfels_.memory(); }

 private:
  LikelihoodGrid likelihood_;
  SurfelMap surfels_;
};

}  // namespace frontier_pilot::scan_matching
