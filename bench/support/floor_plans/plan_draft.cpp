#include "support/floor_plans/plan_draft.h"

#include "frontier_pilot/grids/distance_field.h"

namespace frontier_pilot::bench {
namespace {

constexpr double kVisibleDepth = 0.26;  ///< how deep walls and furniture appear on the map [m]

GridGeometry geometryOf(int width, int height, int margin) {
  GridGeometry geometry;
  geometry.width = width + 2 * margin;
  geometry.height = height + 2 * margin;
  return geometry;
}

}  // namespace

PlanDraft::PlanDraft(int width, int height) : cells_(geometryOf(width, height, kMargin), PlanCell::kWall) {}

template <class Change>
void PlanDraft::change(const CellRect& area, Change change) {
  const CellRect inside =
      CellRect{area.x + kMargin, area.y + kMargin, area.width, area.height}.intersection(cells_.geometry().rect());
  for (int y = inside.y; y < inside.y + inside.height; ++y) {
    for (int x = inside.x; x < inside.x + inside.width; ++x) change(cells_[Cell{x, y}]);
  }
}

void PlanDraft::carve(const CellRect& area) {
  change(area, [](PlanCell& cell) {
    if (cell == PlanCell::kWall) cell = PlanCell::kFloor;
  });
}

void PlanDraft::addRoom(const CellRect& area) {
  carve(area);
  rooms_.push_back(area);
}

void PlanDraft::wall(const CellRect& area) {
  change(area, [](PlanCell& cell) { cell = PlanCell::kWall; });
}

void PlanDraft::addDoor(const CellRect& room, Side side, int offset, int width, int wall) {
  const WallFrame frame(room, side);
  carve(frame.cells({offset, -wall, width, wall}));
  const int side_room = cm(10);
  keepClear(frame.cells({offset - side_room, 0, width + 2 * side_room, cm(90)}));
  keepClear(frame.cells({offset, -wall, width, wall}));
  keepClear(frame.cells({offset - side_room, -wall - cm(70), width + 2 * side_room, cm(70)}));
}

void PlanDraft::keepClear(const CellRect& area) {
  change(area, [](PlanCell& cell) {
    if (cell == PlanCell::kFloor) cell = PlanCell::kPassage;
  });
}

void PlanDraft::furnish(const CellRect& area) {
  change(area, [](PlanCell& cell) {
    if (cell == PlanCell::kFloor) cell = PlanCell::kFurniture;
  });
}

void PlanDraft::clearOut(const CellRect& area) {
  change(area, [](PlanCell& cell) {
    if (cell == PlanCell::kFurniture) cell = PlanCell::kFloor;
  });
}

bool PlanDraft::isOpen(const CellRect& area) const {
  for (int y = area.y; y < area.y + area.height; ++y) {
    for (int x = area.x; x < area.x + area.width; ++x) {
      if (at({x, y}) != PlanCell::kFloor) return false;
    }
  }
  return true;
}

bool PlanDraft::isSolid(Cell cell) const {
  const PlanCell value = at(cell);
  return value == PlanCell::kWall || value == PlanCell::kFurniture;
}

OccupancyGrid PlanDraft::mapOf(const CellRect& area) const {
  GridGeometry geometry;
  geometry.width = area.width;
  geometry.height = area.height;
  OccupancyGrid map(geometry, kOccupied);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Cell cell = geometry.cell(i);
    if (!isSolid({cell.x + area.x, cell.y + area.y})) map[i] = kFree;
  }
  return map;
}

OccupancyGrid PlanDraft::map() const {
  OccupancyGrid map = mapOf(extent());
  Grid<std::uint8_t> free(map.geometry());
  for (std::size_t i = 0; i < map.size(); ++i) free[i] = map[i] == kFree ? 1 : 0;
  const grids::DistanceField to_floor(free, 2.0 * kVisibleDepth);
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (to_floor.grid()[i] > kVisibleDepth) map[i] = kUnknown;
  }
  return map;
}

}  // namespace frontier_pilot::bench
