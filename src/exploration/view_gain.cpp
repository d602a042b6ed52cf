#include "exploration/view_gain.h"

#include <algorithm>

#include "frontier_pilot/core/grid_traversal.h"

namespace frontier_pilot::exploration {
namespace {

/// Twice the area per radian along one beam, known and unknown [m^2].
struct Sector {
  double known = 0.0;
  double unknown = 0.0;
};

Sector castSector(const OccupancyGrid& map, const Vec2& from, double angle, const ViewParameters& p) {
  Sector sector;
  double end = p.sensor_range;
  double first_unknown = -1.0;
  const Vec2 unit = direction(angle);
  const auto along = [&](Cell c) { return (map.geometry().centre(c) - from).dot(unit); };
  visitCells(map.geometry(), from, from + p.sensor_range * unit, [&](Cell c) {
    const std::int8_t value = map.get(c, kOccupied);  // the map's edge: what lies beyond cannot be explored
    if (isFree(value) && first_unknown < 0.0) return true;
    if (isOccupied(value)) {
      end = std::clamp(along(c), 0.0, p.sensor_range);
      return false;
    }
    if (first_unknown < 0.0) {
      first_unknown = std::clamp(along(c), 0.0, p.sensor_range);
      end = std::min(p.sensor_range, first_unknown + p.unknown_depth);
    }
    return along(c) < end;
  });
  if (first_unknown >= 0.0) sector.unknown = std::max(0.0, end * end - first_unknown * first_unknown);
  sector.known = end * end - sector.unknown;
  return sector;
}

/// Counts the cells of the disc of `radius` cells around `centre`: unknown, free, occupied.
struct Census {
  int unknown = 0, free = 0, occupied = 0;
};
Census countDisc(const OccupancyGrid& map, Cell centre, int radius) {
  Census census;
  const CellRect box = CellRect{centre.x, centre.y, 1, 1}.grown(radius).intersection(map.geometry().rect());
  int half_width = 0;  // of the disc's row, which grows and shrinks by a few cells from one row to the next
  const auto isInside = [&](int dx, int dy) { return dx * dx + dy * dy <= radius * radius; };
  for (int y = box.y; y < box.y + box.height; ++y) {
    while (half_width < radius && isInside(half_width + 1, y - centre.y)) ++half_width;
    while (!isInside(half_width, y - centre.y)) --half_width;
    const int begin = std::max(box.x, centre.x - half_width);
    const int end = std::min(box.x + box.width, centre.x + half_width + 1);
    for (int x = begin; x < end; ++x) {
      const std::int8_t value = map.row(y)[x];
      census.unknown += isUnknown(value) ? 1 : 0;
      census.free += isFree(value) ? 1 : 0;
      census.occupied += isOccupied(value) ? 1 : 0;
    }
  }
  return census;
}

}  // namespace

ViewGain viewGain(const OccupancyGrid& map, const Pose2& from, const ViewParameters& parameters) {
  double known = 0.0;
  double unknown = 0.0;
  for (int i = 0; i < parameters.rays; ++i) {
    const double angle = 2.0 * kPi * i / parameters.rays;
    if (!parameters.shows(angle, from.yaw)) continue;
    const Sector sector = castSector(map, from.position(), angle, parameters);
    known += sector.known;
    unknown += sector.unknown;
  }
  const double all = known + unknown;
  return {unknown * kPi / parameters.rays, all > 0.0 ? unknown / all : 0.0};
}

ViewGain unknownShare(const OccupancyGrid& map, const Vec2& from, double radius) {
  const Census census =
      countDisc(map, map.geometry().cellAt(from), static_cast<int>(std::lround(radius / map.resolution())));
  const int all = census.unknown + census.free + census.occupied;
  const double cell_area = map.resolution() * map.resolution();
  return {census.unknown * cell_area, all > 0 ? static_cast<double>(census.unknown) / all : 0.0};
}

double obstacleDensity(const OccupancyGrid& map, Cell centre, int radius) {
  const Census census = countDisc(map, centre, radius);
  const int known = census.free + census.occupied;
  return known > 0 ? static_cast<double>(census.occupied) / known : 0.0;
}

bool inSight(const OccupancyGrid& map, Cell from, Cell to) {
  const GridGeometry& geometry = map.geometry();
  return visitCells(geometry, geometry.centre(from), geometry.centre(to),
                    [&](Cell c) { return map.contains(c) && isFree(map[c]); });
}

}  // namespace frontier_pilot::exploration
