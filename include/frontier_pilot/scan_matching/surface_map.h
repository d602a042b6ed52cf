#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/scan_matching/parameters.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::scan_matching {

class SurfelMap;

/// What scans are matched with: a likelihood field to search in, and surfels to refine on, of the same points. It grows
/// where points are added.
class SurfaceMap {
 public:
  explicit SurfaceMap(const LikelihoodParameters& parameters = {});
  ~SurfaceMap();
  SurfaceMap(SurfaceMap&&) noexcept;
  SurfaceMap& operator=(SurfaceMap&&) noexcept;
  SurfaceMap(const SurfaceMap&) = delete;
  SurfaceMap& operator=(const SurfaceMap&) = delete;

  /// `points` at `T_map_points`; dense, see `filled`.
  void add(const surfaces::SurfacePoints& points, const Pose2& T_map_points);
  /// As `add`, but for the surfels only: what is known well becomes known better, nothing is found that was not.
  void updateKnown(const surfaces::SurfacePoints& points, const Pose2& T_map_points);

  /// The likelihood field, which is searched: 255 exp(-d^2 / (2 sigma^2)), where d is the distance from the cell's
  /// centre to the nearest point. Thrun, Burgard & Fox, "Probabilistic Robotics", 6.4. Empty until the first point.
  const Grid<std::uint8_t>& field() const;
  /// What a match is refined on.
  const SurfelMap& surfels() const;
  bool empty() const { return field().empty(); }
  /// [bytes]
  std::size_t memory() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace frontier_pilot::scan_matching
