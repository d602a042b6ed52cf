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

/// The map that scans are matched with: a likelihood field for the search and surfels for the refinement, both of the
/// same points. It grows where points are added.
class SurfaceMap {
 public:
  explicit SurfaceMap(const LikelihoodParameters& parameters = {});
  ~SurfaceMap();
  SurfaceMap(SurfaceMap&&) noexcept;
  SurfaceMap& operator=(SurfaceMap&&) noexcept;
  SurfaceMap(const SurfaceMap&) = delete;
  SurfaceMap& operator=(const SurfaceMap&) = delete;

  /// Adds `points`, whose frame is at `T_map_points`; they should be dense, see `filled`.
  void add(const surfaces::SurfacePoints& points, const Pose2& T_map_points);
  /// Adds to existing surfels only, which become more accurate: no surface appears that was not known.
  void updateKnown(const surfaces::SurfacePoints& points, const Pose2& T_map_points);

  /// The likelihood field, which is searched: 255 exp(-d^2 / (2 sigma^2)), where d is the distance from the cell's
  /// centre to the nearest point. Thrun, Burgard & Fox, "Probabilistic Robotics", 6.4. Empty until the first point.
  const Grid<std::uint8_t>& field() const;
  /// The surfels, on which a match is refined.
  const SurfelMap& surfels() const;
  bool empty() const { return field().empty(); }
  /// The memory that the field and the surfels take [bytes].
  std::size_t memory() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The likelihood field alone, for a search that no refinement on surfels follows. `points` [m] are in its frame.
Grid<std::uint8_t> likelihoodField(const surfaces::SurfacePoints& points, const LikelihoodParameters& parameters);

}  // namespace frontier_pilot::scan_matching
