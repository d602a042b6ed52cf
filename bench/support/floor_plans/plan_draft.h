#pragma once

#include <cstdint>
#include <vector>

#include "frontier_pilot/core/grid.h"
#include "support/floor_plans/wall_frame.h"

namespace frontier_pilot::bench {

/// What a piece of a plan's floor is covered with.
enum class PlanCell : std::uint8_t {
  kWall,
  kFloor,
  kPassage,  ///< floor that furniture must not cover
  kFurniture,
};

/// A floor plan while it is drawn. Everything is wall at first; rooms are carved out of it, joined by doors and then
/// furnished. All rectangles are in cells of 5 cm.
class PlanDraft {
 public:
  /// A building whose rooms lie in [0, width) x [0, height).
  PlanDraft(int width, int height);

  /// Makes `area` floor that is not a room of its own: a corridor or an opening in a wall.
  void carve(const CellRect& area);
  /// The same, and notes it among the rooms.
  void addRoom(const CellRect& area);
  /// Makes `area` wall, whatever it was.
  void wall(const CellRect& area);
  /// Opens the wall of thickness `wall` outside of the side `side` of `room`, over `width` from `offset` along it, and
  /// keeps furniture away from both ends of the passage. The floor on both sides must have been carved.
  void addDoor(const CellRect& room, Side side, int offset, int width, int wall);
  /// Keeps furniture away from the floor of `area`.
  void keepClear(const CellRect& area);
  /// Puts furniture on the floor of `area`.
  void furnish(const CellRect& area);
  /// Takes all furniture out of `area`.
  void clearOut(const CellRect& area);

  /// Whether all of `area` is floor on which furniture may stand.
  bool isOpen(const CellRect& area) const;
  /// Whether a wall or furniture is there.
  bool isSolid(Cell cell) const;

  const std::vector<CellRect>& rooms() const { return rooms_; }
  /// The building with the margin of the picture around it.
  CellRect extent() const { return {-kMargin, -kMargin, cells_.width(), cells_.height()}; }
  /// The cells of `area` as a map, in which everything is either free or occupied.
  OccupancyGrid mapOf(const CellRect& area) const;
  /// The whole plan as a map: its cell (0, 0) is the lower left one of `extent`. Walls and furniture are occupied as
  /// deep as a map of them would show, and unknown behind that.
  OccupancyGrid map() const;

 private:
  static constexpr int kMargin = cm(50);  ///< of the picture around the building

  template <class Change>
  void change(const CellRect& area, Change change);
  PlanCell at(Cell cell) const { return cells_.get({cell.x + kMargin, cell.y + kMargin}, PlanCell::kWall); }

  Grid<PlanCell> cells_;  ///< cell (0, 0) of the building is cell (kMargin, kMargin) of this grid
  std::vector<CellRect> rooms_;
};

}  // namespace frontier_pilot::bench
