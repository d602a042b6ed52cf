#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::fleet {

/// Whether the first source of a MergedMap, the one with index 0, prevails wherever it knows a cell.
enum class FirstSource {
  kPrevails,  ///< a robot's own map in its own view: its cells are passed on as they are
  kIsEqual,   ///< the common map
};

/// What became of a source.
enum class SourceResult {
  kTaken,
  kOtherResolution,  ///< its cells have another size than those of the sources before it
  kTooLarge,         ///< with it the map would have more cells, or reach farther, than core/bounds.h allows
};

/// What others know of a map that goes on changing: a copy that is brought up to date from time to time, and which
/// tells what that has changed in it. The box around all changes of a scan has many times as many cells.
class MapSnapshot {
 public:
  /// Takes over the cells `changed` of `map`, or all of them if its geometry is new. Returns the parts in which the
  /// copy has changed, blocks of at most 16 cells a side; the whole map if it has not merely grown.
  std::vector<CellRect> take(const OccupancyGrid& map, const CellRect& changed);
  const OccupancyGrid& map() const { return map_; }

 private:
  OccupancyGrid map_;
};

/// One occupancy grid in the frame `target`, assembled from the grids of several sources, whose frames have known poses
/// in it. [MUL-1]
///
/// The cells of the map are those of source 0 if its frame is the target (its transform is the identity), which then
/// passes through it exactly; otherwise the origin of the target lies on a corner of a cell. Each cell takes from a
/// source the cell that its own centre lies in. So a rotation leaves no holes, and the map is a function of the
/// sources alone, whatever the order of the updates. Its extent is the box around all of them.
///
/// Where sources differ, known prevails over unknown, and occupied over free, because two views of one wall that are a
/// few centimetres apart must not erase each other. An exception is an occupied cell around which another source knows
/// nothing but free space for kClearance: no such error explains it. It is where something moved, most often one of
/// the robots, which are not part of the map [MUL-3], and the cell is free. Where no source knows a cell, but one of
/// its corners lies in a wall of a rotated source, it is occupied: the diagonal steps of a wall of one cell would
/// otherwise have corners where free and unknown space meet, which look like frontiers.
///
/// Costs follow what changed: an update redraws its own cells, a new transform the share of its source. When the
/// extent changes, the cells are copied. A map that has grown is drawn as a whole, or only where it has changed if that
/// is told in parts.
class MergedMap {
 public:
  /// How much free space has to surround an occupied cell of another source to disprove it [m]. More than the error of
  /// a merge, and less than the radius of a robot.
  static constexpr double kClearance = 0.1;

  explicit MergedMap(FirstSource first = FirstSource::kIsEqual) : first_(first) {}

  /// Takes over the cells `changed` of `grid`, whose frame has the pose `T_target_source`, which has to be finite. All
  /// cells are read if the source, the geometry of its grid or its pose is new. `grid` is not copied: it has to live
  /// until the source is removed or replaced by another grid. A source that is refused is removed.
  SourceResult setSource(std::size_t index, const OccupancyGrid& grid, const CellRect& changed,
                         const Pose2& T_target_source);
  /// The same for several parts, as MapSnapshot tells them: of a grid that has merely grown, only these are read.
  SourceResult setSourceParts(std::size_t index, const OccupancyGrid& grid, const std::vector<CellRect>& changed,
                              const Pose2& T_target_source);
  /// The map without that source. Without any source it is empty.
  void removeSource(std::size_t index);
  bool hasSource(std::size_t index) const { return sources_.count(index) != 0; }

  const OccupancyGrid& map() const { return map_; }
  /// The box around the cells that have changed since the last call; all cells if the geometry has changed.
  CellRect takeChanged();

 private:
  struct Source {
    const OccupancyGrid* grid = nullptr;
    GridGeometry geometry;  ///< of the grid when it was last read
    Pose2 T_target_source;
    bool left_out = false;  ///< something was drawn without it, because its grid had another geometry by then
  };
  using Sources = std::map<std::size_t, Source>;
  /// Where the cells of the map lie in a source. Lengths are in cells of the source.
  struct Sampler {
    const OccupancyGrid* grid;
    GridGeometry geometry;  ///< that the rest holds for
    bool current;           ///< whether the grid still has it; if not, it is left out until it is set again
    Vec2 origin;            ///< of the map, its lower left corner
    Vec2 x_axis;            ///< of the map
    bool aligned;           ///< each cell of the map coincides with one of the source
    bool is_first;          ///< its index is 0

    /// The source's cell at a point that is given in cells of the map.
    Cell at(double x, double y) const;
    std::int8_t value(Cell cell) const { return grid->get(at(cell.x + 0.5, cell.y + 0.5), kUnknown); }
  };

  SourceResult replace(std::size_t index, const Source& source);
  /// Whether a map of these sources would be larger than core/bounds.h allows.
  static bool tooLarge(const Sources& sources);
  /// The geometry of a map of these sources.
  static GridGeometry extentOf(const Sources& sources);
  /// Makes `sources` those of the map, without drawing anything. False if its cells are others now: all are unknown.
  bool adopt(Sources sources);
  /// Makes `sources` those of the map, of which only the one with `index` is new, gone, or somewhere else.
  void rearrange(Sources sources, std::size_t index);
  void makeSamplers();
  /// The cells of the map that the cells `cells` of a source can affect.
  CellRect footprint(const Source& source, const CellRect& cells) const;
  /// The same for all cells of source `index` of `sources`, as far as they lie in the map; empty without it.
  CellRect shareOf(const Sources& sources, std::size_t index) const;
  void redraw(const CellRect& cells);
  /// The value of a cell by all sources.
  std::int8_t combined(Cell cell) const;
  /// Whether a source knows only free space around `cell`.
  bool provedFree(Cell cell) const;
  /// Whether a corner of `cell` lies in an occupied cell of a rotated source.
  bool touchesWall(Cell cell) const;

  FirstSource first_;
  Sources sources_;
  std::vector<Sampler> samplers_;  ///< one for each source, in the order of their indices
  OccupancyGrid map_;
  CellRect changed_;
};

}  // namespace frontier_pilot::fleet
