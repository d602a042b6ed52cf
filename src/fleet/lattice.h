#pragma once

#include <cmath>
#include <optional>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/grid.h"

/// Whether the cells of two grids coincide.
namespace frontier_pilot::fleet {

/// Resolutions and offsets that differ by less are the same: messages carry them as single-precision numbers [cells].
inline constexpr double kSameCell = 1e-3;

inline bool sameResolution(const GridGeometry& a, const GridGeometry& b) {
  return std::abs(a.resolution - b.resolution) < 1e-6 * a.resolution;
}

inline bool isWhole(double value) { return std::abs(value - std::round(value)) < kSameCell; }
inline bool isWhole(const Vec2& value) { return isWhole(value.x()) && isWhole(value.y()); }

/// Where `to` begins in `from` [cells].
inline Vec2 offset(const GridGeometry& from, const GridGeometry& to) {
  return (to.origin - from.origin) / from.resolution;
}

inline Cell rounded(const Vec2& cells) {
  return {static_cast<int>(std::lround(cells.x())), static_cast<int>(std::lround(cells.y()))};
}

/// Where a grid that has grown holds what it was: `before` lies in `now` from this cell on. Nothing if it does not, or
/// if its cells are others.
inline std::optional<Cell> placeOfOld(const GridGeometry& before, const GridGeometry& now) {
  const Vec2 cells = offset(now, before);
  const bool is_near = bounds::isWithin(cells.cwiseAbs().maxCoeff(), bounds::kMostSide);
  if (before.size() == 0 || !is_near || !sameResolution(before, now) || !isWhole(cells)) return std::nullopt;
  const Cell place = rounded(cells);
  const CellRect old{place.x, place.y, before.width, before.height};
  return old.intersection(now.rect()) == old ? std::optional(place) : std::nullopt;
}

}  // namespace frontier_pilot::fleet
