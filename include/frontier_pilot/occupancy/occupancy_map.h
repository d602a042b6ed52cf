#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/occupancy/parameters.h"

namespace frontier_pilot::occupancy {

class OctreeLayer;

/// The inverse sensor model in log-odds; `min` and `max` are the clamping bounds.
struct LogOddsModel {
  float hit, miss, min, max;

  explicit LogOddsModel(const OccupancyModel& model);
  float clamp(float log_odds) const { return std::min(std::max(log_odds, min), max); }
};

/// What became different since the last time one asked.
struct MapChanges {
  bool geometry_changed = false;  ///< the map has grown: every cell has a new index
  CellRect cells;                 ///< the values that differ lie in here; the whole map when it has grown

  bool empty() const { return !geometry_changed && cells.empty(); }
};

/// The map: log-odds per cell in an octree [MAP-2], a dense copy of them for speed, and their projection to an
/// OccupancyGrid, kept up to date cell by cell. It grows, and never shrinks. The grid's origin is a multiple of the
/// resolution, so cells keep their place in the frame.
class OccupancyMap {
 public:
  explicit OccupancyMap(const OccupancyMapParameters& parameters = {});
  ~OccupancyMap();
  OccupancyMap(OccupancyMap&&) noexcept;
  OccupancyMap& operator=(OccupancyMap&&) noexcept;
  OccupancyMap(const OccupancyMap&) = delete;
  OccupancyMap& operator=(const OccupancyMap&) = delete;

  const OccupancyMapParameters& parameters() const { return parameters_; }
  /// The projection: -1 unknown, 0 free ... 100 occupied. Empty until the first `reserve`.
  const OccupancyGrid& grid() const { return grid_; }
  const GridGeometry& geometry() const { return grid_.geometry(); }
  const OctreeLayer& octree() const { return *octree_; }

  /// Grows so that the box `low`-`high` [m] is inside. False, and nothing happens, when the map would get too large.
  bool reserve(const Vec2& low, const Vec2& high);

  /// From here on each cell takes one more update: a hit wins when it is told before the misses.
  void beginScan();
  /// A beam ended in `cell`, which must be inside.
  void hit(Cell cell) {
    Entry& entry = entries_[cell];
    if (entry.scan == scan_) return;
    entry.scan = scan_;
    if (entry.log_odds != model_.max) change(geometry().index(cell), model_.hit);
  }
  /// A beam passed `cell`, which must be inside.
  void miss(Cell cell) {
    Entry& entry = entries_[cell];
    // What is as surely free as it may be stays: most cells end here, at the cost of one load.
    if (entry.log_odds == model_.min || entry.scan == scan_) return;
    entry.scan = scan_;
    change(geometry().index(cell), model_.miss);
  }
  bool isOccupied(Cell cell) const { return frontier_pilot::isOccupied(grid_[cell]); }

  /// What changed since the last call.
  MapChanges takeChanges();
  /// Between the two the octree lags behind: to put many scans in at once, which is faster so. Only where it is empty.
  void beginBatch() { in_batch_ = true; }
  void endBatch();

  /// Forgets every cell and keeps the geometry.
  void clear();
  /// Whether `exchange` would succeed.
  bool hasRoomFor(const OccupancyMap& other) const;
  /// Takes over the content of `other`, of the same parameters, which gets ours. The map may grow by that, and what
  /// differs counts as changed. False, and nothing happens, when it would get too large.
  bool exchange(OccupancyMap& other);

  /// Octomap's binary format. False when the stream fails.
  bool write(std::ostream& out);
  /// Replaces the map by what `write` gave. False, nothing is changed, and `why` says the reason, when the bytes are
  /// not all of an octree of this resolution, or one that is too large.
  bool read(const std::string& bytes, std::string& why);
  /// What `read` takes at most [bytes].
  std::size_t mostBytes() const;

  /// The dense copy's log-odds; no value where unknown. For tests and pictures.
  bool logOdds(Cell cell, float& value) const;

 private:
  static constexpr float kUnknownLogOdds = 1e9F;
  struct Entry {
    float log_odds = kUnknownLogOdds;
    std::uint32_t scan = 0;  ///< the last scan that said something about this cell
  };

  void change(std::size_t index, float step);
  void store(std::size_t index);
  void project(std::size_t index, float log_odds);
  std::int8_t value(float log_odds) const;
  std::uint64_t mostNodes() const;
  CellRect needed(const Vec2& low, const Vec2& high) const;
  CellRect snapped(const CellRect& cells) const;
  bool isAllowed(const CellRect& snapped) const;
  bool reserveCells(const CellRect& cells);
  void resize(const CellRect& cells);

  OccupancyMapParameters parameters_;
  LogOddsModel model_;
  std::unique_ptr<OctreeLayer> octree_;
  CellRect extent_;      ///< the grid's place, in cells from the frame's origin
  Grid<Entry> entries_;  ///< the octree's layer, dense
  OccupancyGrid grid_;
  std::uint32_t scan_ = 0;
  bool in_batch_ = false;
  MapChanges changes_;
};

}  // namespace frontier_pilot::occupancy
