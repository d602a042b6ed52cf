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

/// What has changed since the changes were last taken.
struct MapChanges {
  bool geometry_changed = false;  ///< the map has grown: cell indices have changed
  CellRect cells;                 ///< bounds of the cells whose values differ; the whole map when it has grown

  bool empty() const { return !geometry_changed && cells.empty(); }
};

/// The map: log-odds per cell in an octree [MAP-2], a dense copy of them for speed, and their projection to an
/// OccupancyGrid, kept up to date cell by cell. It grows, and never shrinks. The grid's origin is a multiple of the
/// resolution, so that cells keep their positions in the frame.
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

  /// Grows so that the box `low`-`high` [m] is inside. Returns false, and does nothing, if the map would be too large.
  bool reserve(const Vec2& low, const Vec2& high);

  /// Begins a scan, which updates each cell at most once: report hits before misses, so that hits take precedence.
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
    // Nothing to do at the lower clamping bound: most calls end here, at the cost of one load.
    if (entry.log_odds == model_.min || entry.scan == scan_) return;
    entry.scan = scan_;
    change(geometry().index(cell), model_.miss);
  }
  bool isOccupied(Cell cell) const { return frontier_pilot::isOccupied(grid_[cell]); }

  /// What changed since the last call.
  MapChanges takeChanges();
  /// Between the two calls the octree is not updated, which makes inserting many scans faster. Only for an empty map.
  void beginBatch() { in_batch_ = true; }
  void endBatch();

  /// Forgets every cell and keeps the geometry.
  void clear();
  /// Whether `exchange` would succeed.
  bool hasRoomFor(const OccupancyMap& other) const;
  /// Swaps the contents with `other`, which must have the same parameters. The map grows to cover both, and cells that
  /// differ count as changed. Returns false, and does nothing, when it would be too large.
  bool exchange(OccupancyMap& other);

  /// Writes OctoMap's binary format. Returns false when the stream fails.
  bool write(std::ostream& out);
  /// Replaces the map by one that `write` wrote. Returns false, changes nothing, and gives the reason in `why`, when
  /// the bytes are not a complete octree of this resolution, or it is too large or empty at the scanner's height.
  bool read(const std::string& bytes, std::string& why);
  /// The greatest size that `read` accepts [bytes].
  std::size_t mostBytes() const;

  /// The dense copy's log-odds; no value where unknown. For tests and pictures.
  bool logOdds(Cell cell, float& value) const;

 private:
  static constexpr float kUnknownLogOdds = 1e9F;
  struct Entry {
    float log_odds = kUnknownLogOdds;
    std::uint32_t scan = 0;  ///< number of the last scan that updated this cell
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
  CellRect extent_;      ///< the grid's extent, in cells from the frame's origin
  Grid<Entry> entries_;  ///< a dense copy of the octree's layer
  OccupancyGrid grid_;
  std::uint32_t scan_ = 0;
  bool in_batch_ = false;
  MapChanges changes_;
};

}  // namespace frontier_pilot::occupancy
