#include "fleet/place/map_windows.h"

#include <algorithm>
#include <map>
#include <utility>

namespace frontier_pilot::fleet {
namespace {

using surfaces::SurfacePoint;
using surfaces::SurfacePoints;

constexpr double kWindowSpacing = 2.5;  // between the centres of windows [m]
constexpr double kWindowRadius = 3.5;   // [m]
constexpr double kPointSpacing = 0.2;   // between the points of a window [m]

/// Orders cells by columns.
struct ByColumn {
  bool operator()(const Cell& one, const Cell& other) const {
    return std::make_pair(one.x, one.y) < std::make_pair(other.x, other.y);
  }
};

/// `windows` in a circle that begins behind the cell `after`.
std::vector<MapWindow> circleFrom(const std::optional<Cell>& after, std::vector<MapWindow> windows) {
  const auto is_later = [&](const MapWindow& window) { return !after || ByColumn()(*after, window.cell); };
  std::rotate(windows.begin(), std::find_if(windows.begin(), windows.end(), is_later), windows.end());
  return windows;
}

}  // namespace

SurfacePoints MapWindow::pointsOf(const SurfacePoints& surface) const {
  const GridGeometry lattice{kPointSpacing};
  std::map<Cell, SurfacePoint, ByColumn> cells;
  for (const SurfacePoint& point : surface) {
    SurfacePoint moved = point;
    moved.position -= centre;
    if (moved.position.squaredNorm() <= square(kWindowRadius)) cells.try_emplace(lattice.cellAt(moved.position), moved);
  }
  SurfacePoints points;
  for (const auto& entry : cells) points.push_back(entry.second);
  return points;
}

std::vector<MapWindow> windowsOf(const SurfacePoints& surface) {
  const GridGeometry lattice{kWindowSpacing};
  std::map<Cell, std::pair<Vec2, int>, ByColumn> cells;
  for (const SurfacePoint& point : surface) {
    auto& [sum, count] = cells.try_emplace(lattice.cellAt(point.position), Vec2::Zero(), 0).first->second;
    sum += point.position;
    ++count;
  }
  std::vector<MapWindow> windows;
  for (const auto& [cell, sum] : cells) windows.push_back({cell, sum.first / sum.second});
  return windows;
}

std::vector<MapWindow> WindowRound::next(const std::vector<MapWindow>& windows,
                                         const std::function<bool(const Vec2& in_a)>& is_known) {
  std::vector<MapWindow> chosen;
  const std::vector<MapWindow> circle = circleFrom(after, windows);
  for (const MapWindow& window : circle) {
    if (T_a_b_guess && chosen.size() < most / 2 && is_known(*T_a_b_guess * window.centre)) chosen.push_back(window);
  }
  for (const MapWindow& window : circle) {
    if (chosen.size() == most) break;
    const auto is_it = [&](const MapWindow& other) { return other.cell == window.cell; };
    if (std::any_of(chosen.begin(), chosen.end(), is_it)) continue;
    chosen.push_back(window);
    after = window.cell;
  }
  return chosen;
}

}  // namespace frontier_pilot::fleet
