#pragma once

#include <QImage>
#include <QRectF>
#include <cstdint>
#include <vector>

#include "gui/theme.h"
#include "teleop/map_view.h"

class QPainter;

namespace frontier_pilot::gui {

/// The cells of a map as images: one pixel for each cell, and coarser ones in which a pixel stands for 2 x 2, 4 x 4,
/// ... cells and shows the most occupied of them, so that thin walls do not vanish in a view from afar. Only what has
/// changed is written again.
class MapImage {
 public:
  /// Takes over the change. One that does not fit its own geometry, or the present map, is left out. [FLT-1]
  void apply(const teleop::MapChange& change);
  bool empty() const { return levels_.empty(); }
  const GridGeometry& geometry() const { return geometry_; }
  /// The value of a cell, as in OccupancyGrid; unknown outside of the map.
  std::int8_t at(Cell cell) const;
  /// A rectangle in the map's frame [m] that contains all known cells and at each side exceeds the smallest one by less
  /// than a pixel of the coarsest image; all of the map if nothing is known.
  QRectF knownArea() const;
  /// The colour of cells of which nothing is known.
  static QColor unknownColor(const Theme& theme);
  /// Draws what lies in `visible` (in the map's frame [m]). The painter's transform maps that frame to pixels, of which
  /// `scale` make a metre.
  void paint(QPainter& painter, const QRectF& visible, double scale, const Theme& theme);

 private:
  void rebuild(const GridGeometry& geometry);
  void write(const teleop::MapChange& change);
  /// Derives the block of a coarser level from the next finer one; gives the block in pixels of that level.
  CellRect reduce(std::size_t level, const CellRect& finer);

  GridGeometry geometry_;
  std::vector<QImage> levels_;  ///< the finest first; row 0 is the lowest row of the map
};

}  // namespace frontier_pilot::gui
