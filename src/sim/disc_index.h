#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::sim {

/// A round thing that scanners see and robots collide with.
struct Disc {
  Vec2 centre = Vec2::Zero();  ///< [m], in the world's frame
  double radius = 0.0;         ///< [m]
  /// Radius of the disc inside the outline of a robot, as which a scanner within this one sees it; 0 for an obstacle
  /// [m].
  double inner = 0.0;
};

/// Discs in square bins: the cost of finding those near a point depends on what lies there, not on their total number.
class DiscIndex {
 public:
  using Id = std::uint32_t;

  DiscIndex() = default;
  /// Covers the area of `geometry`; discs outside of it are put into the bins at its border.
  explicit DiscIndex(const GridGeometry& geometry);

  Id add(const Disc& disc);
  void move(Id id, const Vec2& centre);
  void remove(Id id);
  const Disc& operator[](Id id) const { return discs_[id]; }

  /// Calls `visit(Id, const Disc&)` for every disc that reaches within `radius` [m] of `point`, and for some others; a
  /// disc that lies in several bins may be visited several times.
  template <class Visit>
  void visitNear(const Vec2& point, double radius, Visit&& visit) const {
    const Vec2 reach(radius, radius);
    visitIn(point - reach, point + reach, std::forward<Visit>(visit));
  }
  /// The same for every disc that reaches into the box `low`-`high` [m].
  template <class Visit>
  void visitIn(const Vec2& low, const Vec2& high, Visit&& visit) const {
    const CellRect bins = binsIn(low, high);
    for (int y = bins.y; y < bins.y + bins.height; ++y) {
      for (int x = bins.x; x < bins.x + bins.width; ++x) {
        for (const Id id : bins_[Cell{x, y}]) visit(id, discs_[id]);
      }
    }
  }

 private:
  CellRect binsIn(const Vec2& low, const Vec2& high) const;
  CellRect binsOf(const Disc& disc) const;
  void file(Id id);
  void unfile(Id id);

  Grid<std::vector<Id>> bins_;
  std::vector<Disc> discs_;
  std::vector<Id> unused_;
};

}  // namespace frontier_pilot::sim
