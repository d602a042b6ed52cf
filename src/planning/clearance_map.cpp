#include "frontier_pilot/planning/clearance_map.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "frontier_pilot/core/grid_traversal.h"

namespace frontier_pilot::planning {
namespace {

/// Half a cell's diagonal, the interpolation error and a small margin [cells]; see ClearanceMap.
constexpr double kDiscretisation = 0.9;
/// The same for a tight place: a Burger just fits diagonally between obstacle cells two rows and columns from its own.
constexpr double kTightDiscretisation = 0.4;
/// Keeps a distance that equals the required one valid, however it was rounded [m].
constexpr double kRounding = 1e-5;

GridGeometry tileGeometry(const GridGeometry& cells, int tile) {
  GridGeometry tiles;
  tiles.width = (cells.width + tile - 1) / tile;
  tiles.height = (cells.height + tile - 1) / tile;
  return tiles;
}

/// The interpolated field at a point given in cells, (0, 0) at the centre of the first one, and within its cells.
double interpolated(const Grid<float>& field, double x, double y) {
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, field.width() - 1);
  const float* low = field.row(y0);
  const float* high = field.row(std::min(y0 + 1, field.height() - 1));
  const double u = x - x0;
  const double v = y - y0;
  const double below = (1.0 - u) * static_cast<double>(low[x0]) + u * static_cast<double>(low[x1]);
  const double above = (1.0 - u) * static_cast<double>(high[x0]) + u * static_cast<double>(high[x1]);
  return (1.0 - v) * below + v * above;
}

/// A segment in units of cells, (0, 0) at the centre of the first one, for looking at the field along it.
class FieldAlong {
 public:
  FieldAlong(const grids::DistanceField& field, const Vec2& from, const Vec2& to)
      : field_(field.grid()),
        limit_(field.geometry().width - 1.0, field.geometry().height - 1.0),
        from_((from - field.geometry().origin) / field.geometry().resolution - Vec2(0.5, 0.5)),
        step_((to - from) / field.geometry().resolution),
        per_step_(inverse(step_.x()), inverse(step_.y())) {}

  /// The least distance in `cell` [m]. Within one cell it varies too smoothly for a dip between the three points
  /// checked.
  double least(Cell cell) const {
    double first = 0.0;
    double last = 1.0;
    clip((cell.x - from_.x()) * per_step_.x(), 0.5 * std::abs(per_step_.x()), first, last);
    clip((cell.y - from_.y()) * per_step_.y(), 0.5 * std::abs(per_step_.y()), first, last);
    return std::min({at(first), at(0.5 * (first + last)), at(last)});
  }

 private:
  /// 0 if the segment does not move along the axis: then it lies in the cells of one row or column from end to end.
  static double inverse(double step) { return std::abs(step) < 1e-9 ? 0.0 : 1.0 / step; }
  static void clip(double middle, double half, double& first, double& last) {
    if (half == 0.0) return;
    first = std::max(first, middle - half);
    last = std::min(last, middle + half);
  }
  double at(double part) const {
    return interpolated(field_, std::clamp(from_.x() + part * step_.x(), 0.0, limit_.x()),
                        std::clamp(from_.y() + part * step_.y(), 0.0, limit_.y()));
  }

  const Grid<float>& field_;
  Vec2 limit_;
  Vec2 from_;
  Vec2 step_;
  Vec2 per_step_;
};

}  // namespace

ClearanceMap::ClearanceMap(const ClearanceParams& params) : params_(params) {}

bool ClearanceMap::setMap(const OccupancyGrid& map, const CellRect& changed) {
  if (empty() || map.geometry() != geometry()) {
    reset(map);
    return true;
  }
  const CellRect cells = changed.intersection(geometry().rect());
  for (int y = cells.y; y < cells.y + cells.height; ++y) takeRow(map.row(y) + cells.x, {cells.x, y}, cells.width);
  return false;
}

void ClearanceMap::reset(const OccupancyGrid& map) {
  required_ = params_.inscribed_radius + kDiscretisation * map.resolution() - kRounding;
  least_ = params_.tight_weight > 0.0 ? params_.inscribed_radius + kTightDiscretisation * map.resolution() : required_;
  weights_[kTightClass] = std::max(params_.tight_weight, 1.0 + params_.wall_weight);
  for (int i = 1; i < kTightClass; ++i) {
    const double nearness = 1.0 - static_cast<double>(i - 1) / (kTightClass - 2);
    weights_[static_cast<std::size_t>(i)] = 1.0 + params_.wall_weight * nearness * nearness;
  }
  const GridGeometry& cells = map.geometry();
  state_ = Grid<std::uint8_t>(cells, kStateUnknown);
  live_ = Grid<std::uint8_t>(cells, 0);
  obstacle_ = Grid<std::uint8_t>(cells, 0);
  cost_ = Grid<std::uint8_t>(cells, 0);
  dirty_tiles_ = Grid<std::uint8_t>(tileGeometry(cells, kTile), kTileClean);
  for (int y = 0; y < cells.height; ++y) takeRow(map.row(y), {0, y}, cells.width);
  measure();
}

/// Computes field and costs of the whole map.
void ClearanceMap::measure() {
  const GridGeometry& cells = geometry();
  field_ = grids::DistanceField(obstacle_, std::max(params_.preferred_clearance, required_) + cells.resolution);
  std::fill(dirty_tiles_.cells().begin(), dirty_tiles_.cells().end(), static_cast<std::uint8_t>(kTileClean));
  rateCells(cells.rect());
}

bool ClearanceMap::setParams(const ClearanceParams& params) {
  const bool differs = params.preferred_clearance != params_.preferred_clearance ||
                       params.unknown_is_traversable != params_.unknown_is_traversable;
  params_.preferred_clearance = params.preferred_clearance;
  params_.unknown_is_traversable = params.unknown_is_traversable;
  if (differs && !empty()) measure();
  return differs;
}

void ClearanceMap::takeRow(const std::int8_t* map, Cell from, int count) {
  const auto size = static_cast<std::size_t>(count);
  row_.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    row_[i] = map[i] < 0 ? kStateUnknown : (map[i] < 50 ? kStateFree : kStateOccupied);
  }
  const std::uint8_t* before = state_.row(from.y) + from.x;
  for (int i = 0; i < count; i += kTile) {
    const int length = std::min(kTile, count - i);
    if (std::memcmp(before + i, row_.data() + i, static_cast<std::size_t>(length)) == 0) continue;
    for (int k = i; k < i + length; ++k) setCell({from.x + k, from.y}, row_[static_cast<std::size_t>(k)]);
  }
}

void ClearanceMap::setCell(Cell cell, std::uint8_t state) {
  if (state_[cell] == state) return;
  state_[cell] = state;
  std::uint8_t& tile = dirty_tiles_[Cell{cell.x / kTile, cell.y / kTile}];
  const std::uint8_t obstacle = state == kStateOccupied || live_[cell] != 0 ? 1 : 0;
  tile = std::max<std::uint8_t>(tile, obstacle != obstacle_[cell] ? kTileField : kTileCost);
  obstacle_[cell] = obstacle;
}

void ClearanceMap::setLive(Cell cell, bool obstacle) {
  live_[cell] = obstacle ? 1 : 0;
  const std::uint8_t now = obstacle || state_[cell] == kStateOccupied ? 1 : 0;
  if (now == obstacle_[cell]) return;
  obstacle_[cell] = now;
  dirty_tiles_[Cell{cell.x / kTile, cell.y / kTile}] = kTileField;
}

int ClearanceMap::fieldReach() const {
  // One more cell: whether a cell is roomy depends on its neighbours.
  return static_cast<int>(std::ceil(field_.maxDistance() / geometry().resolution)) + 1;
}

CellRect ClearanceMap::refresh() {
  CellRect touched;
  for (int y = 0; y < dirty_tiles_.height(); ++y) {
    std::uint8_t* row = dirty_tiles_.row(y);
    for (int x = 0; x < dirty_tiles_.width(); ++x) {
      if (row[x] == kTileClean) continue;
      const std::uint8_t level = row[x];
      const int first = x;
      while (x < dirty_tiles_.width() && row[x] == level) row[x++] = kTileClean;
      refreshTiles({first, y}, x - first, level, touched);
      --x;
    }
  }
  return touched;
}

void ClearanceMap::refreshTiles(Cell first_tile, int count, std::uint8_t level, CellRect& touched) {
  const CellRect cells =
      CellRect{first_tile.x * kTile, first_tile.y * kTile, count * kTile, kTile}.intersection(geometry().rect());
  if (level == kTileField) field_.update(obstacle_, cells);
  const CellRect reach = cells.grown(level == kTileField ? fieldReach() : 1).intersection(geometry().rect());
  rateCells(reach);
  touched.include(reach);
}

void ClearanceMap::rateCells(const CellRect& cells) {
  for (int y = cells.y; y < cells.y + cells.height; ++y) {
    for (int x = cells.x; x < cells.x + cells.width; ++x) cost_[Cell{x, y}] = rate({x, y});
  }
}

std::uint8_t ClearanceMap::rate(Cell cell) const {
  const double distance = static_cast<double>(field_[cell]);
  if (distance < least_) return 0;
  if (state_[cell] != kStateFree && !(params_.unknown_is_traversable && state_[cell] == kStateUnknown)) return 0;
  if (distance < required_) return kTightClass;
  const double span = std::max(params_.preferred_clearance, required_) - required_;
  const double room = span > 0.0 ? std::min(1.0, (distance - required_) / span) : 1.0;
  const int cost_class = 1 + static_cast<int>(room * (kTightClass - 2));
  return static_cast<std::uint8_t>(cost_class | (isRoomy(cell) ? kRoomy : 0));
}

bool ClearanceMap::isRoomy(Cell cell) const {
  if (static_cast<double>(field_[cell]) >= required_ + 1.5 * geometry().resolution) return true;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      if (field_.at(Cell{cell.x + dx, cell.y + dy}) < required_) return false;
    }
  }
  return true;
}

bool ClearanceMap::isMapOccupiedNear(Cell c, int radius) const {
  const CellRect cells = CellRect{c.x, c.y, 1, 1}.grown(radius).intersection(geometry().rect());
  for (int y = cells.y; y < cells.y + cells.height; ++y) {
    for (int x = cells.x; x < cells.x + cells.width; ++x) {
      if (state_[Cell{x, y}] == kStateOccupied) return true;
    }
  }
  return false;
}

double ClearanceMap::clearance(const Vec2& point) const {
  const GridGeometry& g = geometry();
  const double limit_x = g.width - 1.0;
  const double limit_y = g.height - 1.0;
  const double x = std::clamp((point.x() - g.origin.x()) / g.resolution - 0.5, 0.0, limit_x);
  const double y = std::clamp((point.y() - g.origin.y()) / g.resolution - 0.5, 0.0, limit_y);
  return interpolated(field_.grid(), x, y);
}

bool ClearanceMap::isValid(const Vec2& point) const {
  const Cell cell = geometry().cellAt(point);
  if (!geometry().contains(cell)) return false;
  if (state_[cell] != kStateFree && !(params_.unknown_is_traversable && state_[cell] == kStateUnknown)) return false;
  return clearance(point) >= least_ - kRounding;
}

double ClearanceMap::segmentCost(const Vec2& from, const Vec2& to, double limit) const {
  const Cell first = geometry().cellAt(from);
  const Cell last = geometry().cellAt(to);
  if (!geometry().contains(first) || !geometry().contains(last)) return -1.0;
  const int count = 1 + std::abs(last.x - first.x) + std::abs(last.y - first.y);
  const double length = (to - from).norm();
  // What all cells together may cost more than the least, which is 1 each, and what those visited do.
  const double most_extra = length > 0.0 ? (limit / length - 1.0) * count : std::numeric_limits<double>::infinity();
  const FieldAlong along(field_, from, to);
  double extra = 0.0;
  bool valid = true;
  visitCells(geometry(), from, to, [&](Cell cell) {
    std::uint8_t cost = cost_[cell];
    if ((cost & kRoomy) == 0) {
      // A segment may still cross the corner of a cell whose centre is too near an obstacle.
      const double distance = cost == 0 && !isKnownFree(cell) ? -1.0 : along.least(cell);
      valid = distance >= least_ - kRounding;
      if (distance < required_ - kRounding) cost = kTightClass;
    }
    extra += weights_[static_cast<std::size_t>(std::max(1, cost & kClassMask))] - 1.0;
    return valid && extra <= most_extra;
  });
  return valid ? length * (1.0 + extra / count) : -1.0;
}

}  // namespace frontier_pilot::planning
