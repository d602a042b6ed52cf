#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <utility>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/grids/growing_grid.h"
#include "frontier_pilot/occupancy/parameters.h"

namespace frontier_pilot::occupancy {

class OctreeLayer;

/// What stands for the log-odds of an unknown cell.
constexpr float kUnknownLogOdds = 1e9F;

/// The inverse sensor model in log-odds; `min` and `max` are the clamping bounds.
struct LogOddsModel {
  float hit, miss, min, max;

  explicit LogOddsModel(const OccupancyModel& model);
  float clamp(float log_odds) const { return std::min(std::max(log_odds, min), max); }
};

/// Whether a map has room for what is to be put into it.
enum class MapRoom {
  kEnough,
  kTooLarge,  ///< the map would be wider or higher than it may be
  kTooFar,    ///< the box lies farther from the frame's origin than a map reaches, that is 32768 cells
  kNoMemory,  ///< its cells need more than `max_memory`
};

/// What has changed since the changes were last taken.
struct MapChanges {
  bool geometry_changed = false;  ///< the map has grown: cell indices have changed
  CellRect cells;                 ///< bounds of the cells whose values differ; the whole map when it has grown

  bool empty() const { return !geometry_changed && cells.empty(); }
};

/// The map: log-odds per cell in tiles that are allocated where something is known, so that memory follows the mapped
/// area and not the box around it. [MAP-2] The box grows, and shrinks only when no cell is known: then it is made anew
/// around what comes next. Its origin is a multiple of the resolution, so that cells keep their positions in the frame.
class OccupancyMap {
 public:
  explicit OccupancyMap(const OccupancyMapParameters& parameters = {});
  ~OccupancyMap();
  OccupancyMap(OccupancyMap&&) noexcept;
  OccupancyMap& operator=(OccupancyMap&&) noexcept;
  OccupancyMap(const OccupancyMap&) = delete;
  OccupancyMap& operator=(const OccupancyMap&) = delete;

  const OccupancyMapParameters& parameters() const { return parameters_; }
  /// The box that the map fills so far. Its size is zero until the first `reserve`.
  const GridGeometry& geometry() const { return geometry_; }
  bool empty() const { return extent_.empty(); }
  /// Whether no cell is known.
  bool isBlank() const { return log_odds_.tileCount() == 0; }
  /// The projection of the whole box: -1 unknown, 0 free ... 100 occupied. From the first call on it is kept, at a byte
  /// for each cell of the box, and brought up to date by each call. For those who need all of it again and again.
  const OccupancyGrid& grid() const;
  /// A copy of the projection of `cells`, which must be inside.
  OccupancyGrid projection(const CellRect& cells) const;
  OccupancyGrid projection() const { return projection(geometry_.rect()); }
  /// Writes the projection of the whole box to `out`, row by row: a byte for each cell.
  void copyTo(std::int8_t* out) const { project(geometry_.rect(), out, geometry_.width); }
  /// The map as OctoMap holds it, made by this call: some 60 bytes for each known cell.
  OctreeLayer octree() const;

  /// The memory of the cells [bytes].
  std::size_t memory() const;
  /// Whether cells were left out, since the map was last cleared, because `max_memory` is used up.
  bool isFull() const { return full_; }

  /// Grows so that the box `low`-`high` [m] is inside; does nothing if there is no room for it.
  MapRoom reserve(const Vec2& low, const Vec2& high);
  /// Why it does not fit, as the end of a sentence; empty if it fits.
  std::string describe(MapRoom room) const;

  /// Begins a scan, which updates each cell at most once: report hits before misses, so that hits take precedence.
  void beginScan();
  /// A beam ended in `cell`, which must be inside.
  void hit(Cell cell) {
    const Cell at = inFrame(cell);
    if (isDone(at)) return;
    if (log_odds_[at] == model_.max) return;
    change(at, model_.hit);
  }
  /// A beam passed `cell`, which must be inside.
  void miss(Cell cell) {
    const Cell at = inFrame(cell);
    // Nothing to do at the lower clamping bound: most calls end here, at the cost of one load.
    if (log_odds_[at] == model_.min || isDone(at)) return;
    change(at, model_.miss);
  }
  /// Whether `cell`, which must be inside, is occupied.
  bool isOccupied(Cell cell) const {
    const float log_odds = log_odds_[inFrame(cell)];
    if (parameters_.probabilities) return frontier_pilot::isOccupied(value(log_odds));
    return log_odds >= 0.0F && log_odds != kUnknownLogOdds;
  }
  /// Whether `cell`, which may be outside, is inside and occupied.
  bool hasWallAt(Cell cell) const { return geometry_.contains(cell) && isOccupied(cell); }
  /// Whether any cell is occupied. Looks at all of them.
  bool hasOccupied() const;

  /// What changed since the last call.
  MapChanges takeChanges();

  /// Forgets every cell. The geometry stays until `reserve` or `exchange` asks for room.
  void clear();
  /// Whether `exchange` would succeed.
  bool hasRoomFor(const OccupancyMap& other) const;
  /// Swaps the contents with `other`, which must have the same parameters. The map grows to cover both, unless no cell
  /// of it is known, and cells that differ count as changed. Returns false, and does nothing, when it would be too
  /// large.
  bool exchange(OccupancyMap& other);
  /// Takes the contents and the box of `other`, which must have the same parameters; `other` is blank afterwards.
  void replaceBy(OccupancyMap& other);

  /// Writes OctoMap's binary format. Returns false when the stream fails.
  bool write(std::ostream& out) const;
  /// Replaces the map by one that `write` wrote. Returns false, changes nothing, and gives the reason in `why`, when
  /// the bytes are not a complete octree of this resolution, or it is too large, too far away, or empty at the
  /// scanner's height.
  bool read(const std::string& bytes, std::string& why);
  /// The greatest size that `read` accepts [bytes].
  std::size_t mostBytes() const;

  /// The log-odds of `cell`, which may be anywhere; false where unknown. For tests and pictures.
  bool logOdds(Cell cell, float& value) const;

 private:
  /// The same cell, counted from the frame's origin.
  Cell inFrame(Cell cell) const { return {cell.x + extent_.x, cell.y + extent_.y}; }
  /// Whether this scan has updated the cell already; from now on it has.
  bool isDone(Cell in_frame) {
    std::uint16_t& scan = scans_.at(in_frame);
    return std::exchange(scan, scan_) == scan_;
  }

  void change(Cell in_frame, float step);
  float* roomFor(Cell in_frame);
  std::int8_t value(float log_odds) const;
  /// Writes the projection of `cells` to `out`, from one row to the next `stride` cells apart.
  void project(const CellRect& cells, std::int8_t* out, std::ptrdiff_t stride) const;
  CellRect changedFrom(const OccupancyMap& other) const;
  std::size_t mostTiles() const;
  std::uint64_t mostNodes() const;
  /// The part of the box that must stay when the map grows: all of it, or nothing if no cell is known.
  CellRect kept() const;
  CellRect needed(const Vec2& low, const Vec2& high) const;
  /// The block of whole growth steps around `cells`; `cells` themselves if that would be too large.
  CellRect snapped(const CellRect& cells) const;
  MapRoom roomAt(const CellRect& cells) const;
  MapRoom reserveCells(const CellRect& cells);
  void resize(const CellRect& cells);

  OccupancyMapParameters parameters_;
  LogOddsModel model_;
  CellRect extent_;        ///< the box, in cells from the frame's origin
  GridGeometry geometry_;  ///< the same in the frame
  grids::TiledGrid<float> log_odds_{kUnknownLogOdds};
  grids::TiledGrid<std::uint16_t> scans_;  ///< numbers of the last scans that updated the cells; only of the last scans
  std::uint16_t scan_ = 0;
  bool full_ = false;
  MapChanges changes_;
  mutable OccupancyGrid grid_;  ///< the projection as it was when it was last asked for; empty until then
  mutable CellRect outdated_;   ///< where it may have changed since then
};

}  // namespace frontier_pilot::occupancy
