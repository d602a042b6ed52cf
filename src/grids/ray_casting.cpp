#include "frontier_pilot/grids/ray_casting.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "grids/leap_builder.h"

namespace frontier_pilot::grids {
namespace {

// Row coordinates are fixed-point numbers: adding slopes is then exact, and a shift gives the cell. With 40 fractional
// bits the error of a slope is 10^-12, which no range of a few thousand cells can reveal.
constexpr int kFraction = 40;
constexpr double kOne = static_cast<double>(std::int64_t{1} << kFraction);

// So many rays take turns in their first kTurns leaps: while one is processed, the memory of the others is fetched.
constexpr std::size_t kAtOnce = 32;
constexpr int kTurns = 5;

int slopeClass(double slope) { return (slope >= 0.125) + (slope >= 0.25) + (slope >= 0.5); }

int planeIndex(bool steep, bool mirror_x, bool mirror_y, int slope_class) {
  return ((steep * 2 + mirror_x) * 2 + mirror_y) * kSlopes + slope_class;
}

}  // namespace

// A start point, in cells, in the unmirrored [0] and the mirrored [1] direction of each axis.
struct RayCaster::Origin {
  double x[2], y[2];
  int cell_x[2], cell_y[2];
};

// A ray on its way in its canonical frame; lengths in cells.
struct RayCaster::Ray {
  const std::uint8_t* plane;
  std::ptrdiff_t stride;
  std::int64_t slope;   // rows per column, fixed point
  std::int64_t height;  // where it enters column `column`, fixed point
  std::int64_t row;
  std::int64_t column;
  std::int64_t end;  // the first column that is out of range
  std::int64_t columns, rows;
  double start_x, start_y;
  double unit_x, unit_y;

  const std::uint8_t* here() const { return plane + column * stride + row; }
  std::uint8_t leap() const { return *here(); }
  bool crosses() const { return ((height + slope) >> kFraction) > row; }
  void advance(std::int64_t by) {
    column += by;
    height += by * slope;
    row = height >> kFraction;
  }
  // Advances until it is in a solid cell, enters the solid cell above it within this column, or is out of range.
  void run() {
    while (column < end) {
      const std::uint8_t stored = leap();
      if (stored > 1) {
        advance(stored - 1);
      } else if (stored == 0 || crosses()) {
        return;
      } else {
        advance(1);
      }
    }
  }
  // One leap, or none where `run` would stop. Free of branches, so that the processor can overlap several rays.
  void leapOnce() {
    const std::uint8_t stored = leap();
    const bool creeps = (stored == 1) & !crosses();
    const std::int64_t row_before = row;
    const std::int64_t by = column < end ? stored - (stored > 0) + creeps : 0;
    advance(by);
    row = by > 0 ? row : row_before;
    __builtin_prefetch(here());
  }
  // The length from the start to where `run` stopped [cells]; `none` if it stopped at the range or the grid's border.
  double length(double none) const {
    if (column >= end) return none;
    if (leap() > 0) return row >= rows ? none : (static_cast<double>(row + 1) - start_y) / unit_y;
    if (column > columns || row > rows) return none;
    return std::max(0.0, (static_cast<double>(column) - start_x) / unit_x);
  }
  double range(double resolution, double max_range) const {
    return std::min(length(std::numeric_limits<double>::infinity()) * resolution, max_range);
  }
};

RayCaster::RayCaster(const Grid<std::uint8_t>& solid)
    : geometry_(solid.geometry()), cells_per_metre_(1.0 / solid.resolution()) {
  const std::size_t plane =
      static_cast<std::size_t>(geometry_.width + 2) * static_cast<std::size_t>(geometry_.height + 2);
  const auto longest_column = static_cast<std::size_t>(std::max(geometry_.width, geometry_.height)) + 2U;
  leaps_.resize(plane * kOctants * kSlopes + longest_column * LeapBuilder::kTailColumns);
  for (int octant = 0; octant < kOctants; ++octant) {
    const bool steep = (octant & 4) != 0;
    const bool mirror_x = (octant & 2) != 0;
    const bool mirror_y = (octant & 1) != 0;
    const LeapBuilder builder(solid, steep, mirror_x, mirror_y);
    for (int slope_class = 0; slope_class < kSlopes; ++slope_class) {
      const auto index = static_cast<std::size_t>(planeIndex(steep, mirror_x, mirror_y, slope_class));
      builder.fill(slope_class, leaps_.data() + index * plane);
    }
  }
}

bool RayCaster::contains(const Vec2& from) const {
  const Vec2 cells = (from - geometry_.origin) / geometry_.resolution;
  return cells.x() >= 0.0 && cells.y() >= 0.0 && cells.x() < geometry_.width && cells.y() < geometry_.height;
}

RayCaster::Origin RayCaster::originAt(const Vec2& from) const {
  const Vec2 cells = (from - geometry_.origin) / geometry_.resolution;
  const int x = std::clamp(static_cast<int>(std::floor(cells.x())), 0, geometry_.width - 1);
  const int y = std::clamp(static_cast<int>(std::floor(cells.y())), 0, geometry_.height - 1);
  return {{cells.x() + 1.0, geometry_.width + 1 - cells.x()},
          {cells.y() + 1.0, geometry_.height + 1 - cells.y()},
          {x + 1, geometry_.width - x},
          {y + 1, geometry_.height - y}};
}

RayCaster::Ray RayCaster::rayAlong(const Origin& origin, const Vec2& unit, double max_cells) const {
  const bool mirror_x = unit.x() < 0.0;
  const bool mirror_y = unit.y() < 0.0;
  const double along_x = std::abs(unit.x());
  const double along_y = std::abs(unit.y());
  const bool steep = along_y > along_x;
  Ray ray;
  ray.unit_x = steep ? along_y : along_x;
  ray.unit_y = steep ? along_x : along_y;
  ray.start_x = steep ? origin.y[mirror_y] : origin.x[mirror_x];
  ray.start_y = steep ? origin.x[mirror_x] : origin.y[mirror_y];
  ray.column = steep ? origin.cell_y[mirror_y] : origin.cell_x[mirror_x];
  ray.row = steep ? origin.cell_x[mirror_x] : origin.cell_y[mirror_y];
  ray.columns = steep ? geometry_.height : geometry_.width;
  ray.rows = steep ? geometry_.width : geometry_.height;
  ray.stride = ray.rows + 2;
  const double slope = ray.unit_y / ray.unit_x;
  ray.slope = static_cast<std::int64_t>(slope * kOne);
  // `height` is extrapolated back to where the line enters the start's column; `row` is that of the start itself.
  ray.height =
      static_cast<std::int64_t>((ray.start_y - slope * (ray.start_x - static_cast<double>(ray.column))) * kOne);
  const double end = std::min(ray.start_x + max_cells * ray.unit_x, static_cast<double>(ray.columns + 1));
  ray.end = static_cast<std::int64_t>(end) + 1;
  const std::size_t plane = static_cast<std::size_t>(ray.columns + 2) * static_cast<std::size_t>(ray.rows + 2);
  ray.plane =
      leaps_.data() + static_cast<std::size_t>(planeIndex(steep, mirror_x, mirror_y, slopeClass(slope))) * plane;
  return ray;
}

double RayCaster::walk(const Origin& origin, const Vec2& unit, double max_range) const {
  Ray ray = rayAlong(origin, unit, max_range * cells_per_metre_);
  ray.run();
  return ray.range(geometry_.resolution, max_range);
}

double RayCaster::cast(const Vec2& from, const Vec2& unit, double max_range) const {
  if (!contains(from)) return castFromOutside(from, unit, max_range);
  return walk(originAt(from), unit, max_range);
}

void RayCaster::castAll(const Vec2& from, const std::vector<Vec2>& units, std::vector<double>& ranges) const {
  if (!contains(from)) {
    for (std::size_t i = 0; i < units.size(); ++i) ranges[i] = castFromOutside(from, units[i], ranges[i]);
    return;
  }
  castInTurns([origin = originAt(from)](std::size_t) -> const Origin& { return origin; }, units, ranges);
}

void RayCaster::castEach(const std::vector<Vec2>& from, const std::vector<Vec2>& units,
                         std::vector<double>& ranges) const {
  if (std::all_of(from.begin(), from.end(), [this](const Vec2& point) { return contains(point); })) {
    return castInTurns([&](std::size_t i) { return originAt(from[i]); }, units, ranges);
  }
  for (std::size_t i = 0; i < units.size(); ++i) ranges[i] = cast(from[i], units[i], ranges[i]);
}

template <class OriginOf>
void RayCaster::castInTurns(const OriginOf& origin_of, const std::vector<Vec2>& units,
                            std::vector<double>& ranges) const {
  std::array<Ray, kAtOnce> rays;
  for (std::size_t first = 0; first < units.size(); first += kAtOnce) {
    const std::size_t count = std::min(kAtOnce, units.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      rays[i] = rayAlong(origin_of(first + i), units[first + i], ranges[first + i] * cells_per_metre_);
      __builtin_prefetch(rays[i].here());
    }
    for (int turn = 0; turn < kTurns; ++turn) {
      for (std::size_t i = 0; i < count; ++i) rays[i].leapOnce();
    }
    for (std::size_t i = 0; i < count; ++i) {
      rays[i].run();
      ranges[first + i] = rays[i].range(geometry_.resolution, ranges[first + i]);
    }
  }
}

double RayCaster::castFromOutside(const Vec2& from, const Vec2& unit, double max_range) const {
  const Vec2 low = geometry_.origin - from;
  const Vec2 high = low + Vec2(geometry_.width, geometry_.height) * geometry_.resolution;
  double enter = 0.0;
  double leave = max_range;
  for (int axis = 0; axis < 2; ++axis) {
    if (unit[axis] == 0.0 && (low[axis] > 0.0 || high[axis] <= 0.0)) return max_range;
    if (unit[axis] == 0.0) continue;
    const auto [near, far] = std::minmax({low[axis] / unit[axis], high[axis] / unit[axis]});
    enter = std::max(enter, near);
    leave = std::min(leave, far);
  }
  if (enter >= leave || geometry_.size() == 0) return max_range;
  return enter + walk(originAt(from + enter * unit), unit, max_range - enter);
}

}  // namespace frontier_pilot::grids
