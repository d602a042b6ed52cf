#include "support/tour/waypoint_graph.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <stdexcept>

#include "frontier_pilot/core/grid_traversal.h"
#include "frontier_pilot/grids/distance_field.h"
#include "sim/reachable_floor.h"

namespace frontier_pilot::bench {
namespace {

constexpr double kMostClearance = 2.0;  // [m]

}  // namespace

Terrain::Terrain(const OccupancyGrid& truth, const Vec2& start, double radius) {
  clearance_ = grids::DistanceField(sim::notFree(truth), kMostClearance).grid();
  const double least = std::ceil(radius / truth.resolution()) * truth.resolution() + 1e-6;
  Grid<std::uint8_t> blocked(truth.geometry());
  for (std::size_t i = 0; i < blocked.size(); ++i) blocked[i] = clearance_[i] > least ? 0 : 1;
  const Cell at = truth.geometry().cellAt(start);
  passable_ = sim::connectedCells(blocked, at);
  if (!isPassable(at)) throw std::invalid_argument("the start of the tour is in or too near a wall");
}

bool Terrain::isStraight(const Vec2& from, const Vec2& to) const {
  return visitCells(geometry(), from, to, [&](Cell cell) { return isPassable(cell); });
}

WaypointGraph::WaypointGraph(const Terrain& terrain, const Vec2& start, double spacing)
    : spacing_(spacing), owner_(terrain.geometry(), -1) {
  addNode(terrain, start);
  placeNodes(terrain);
  linkNeighbours(terrain);
  bridge(terrain);
  if (places_.size() > std::numeric_limits<std::uint16_t>::max()) {
    throw std::invalid_argument("the floor is too large for a tour");
  }
  distance_.assign(places_.size() * places_.size(), std::numeric_limits<float>::infinity());
  next_.assign(distance_.size(), 0);
  for (int node = 0; node < size(); ++node) searchFrom(node);
}

// First a lattice, then places for the cells that no waypoint of it sees near by, those with most clearance first.
void WaypointGraph::placeNodes(const Terrain& terrain) {
  const GridGeometry& cells = terrain.geometry();
  const int step = std::max(1, static_cast<int>(std::lround(spacing_ / cells.resolution)));
  for (int y = step / 2; y < cells.height; y += step) {
    for (int x = step / 2; x < cells.width; x += step) {
      if (terrain.isPassable({x, y})) addNode(terrain, cells.centre({x, y}));
    }
  }
  std::vector<Cell> left;
  for (std::size_t i = 0; i < owner_.size(); ++i) {
    if (owner_[i] < 0 && terrain.isPassable(cells.cell(i))) left.push_back(cells.cell(i));
  }
  std::stable_sort(left.begin(), left.end(),
                   [&](Cell a, Cell b) { return terrain.clearance(a) > terrain.clearance(b); });
  for (const Cell cell : left) {
    if (owner_[cell] < 0) addNode(terrain, cells.centre(cell));
  }
}

void WaypointGraph::addNode(const Terrain& terrain, const Vec2& place) {
  const int node = size();
  places_.push_back(place);
  edges_.emplace_back();
  const GridGeometry& cells = terrain.geometry();
  const Cell at = cells.cellAt(place);
  const int reach = static_cast<int>(0.75 * spacing_ / cells.resolution) + 1;
  const CellRect near = CellRect{at.x, at.y, 1, 1}.grown(reach).intersection(cells.rect());
  for (int y = near.y; y < near.y + near.height; ++y) {
    for (int x = near.x; x < near.x + near.width; ++x) {
      const Cell cell{x, y};
      const Vec2 centre = cells.centre(cell);
      if (owner_[cell] >= 0 || !terrain.isPassable(cell) || (centre - place).norm() > 0.75 * spacing_) continue;
      if (terrain.isStraight(place, centre)) owner_[cell] = node;
    }
  }
}

void WaypointGraph::link(int a, int b) {
  const auto length = static_cast<float>((place(a) - place(b)).norm());
  edges_[static_cast<std::size_t>(a)].push_back({b, length});
  edges_[static_cast<std::size_t>(b)].push_back({a, length});
}

void WaypointGraph::linkNeighbours(const Terrain& terrain) {
  const double reach = 2.3 * spacing_;
  for (int a = 0; a < size(); ++a) {
    for (int b = a + 1; b < size(); ++b) {
      if ((place(a) - place(b)).squaredNorm() <= reach * reach && terrain.isStraight(place(a), place(b))) link(a, b);
    }
  }
}

bool WaypointGraph::areNear(int a, int b) const {
  const auto leads = [&](int from, int to) {
    const std::vector<Edge>& edges = edges_[static_cast<std::size_t>(from)];
    return std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) { return edge.to == to; });
  };
  const std::vector<Edge>& edges = edges_[static_cast<std::size_t>(a)];
  return leads(a, b) || std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) { return leads(edge.to, b); });
}

// Where neighbouring cells belong to waypoints between which there is no near way, both cells become waypoints.
void WaypointGraph::bridge(const Terrain& terrain) {
  const GridGeometry& cells = terrain.geometry();
  for (std::size_t i = 0; i < owner_.size(); ++i) {
    const Cell cell = cells.cell(i);
    for (const Cell next : {Cell{cell.x + 1, cell.y}, Cell{cell.x, cell.y + 1}}) {
      const int a = owner_[i];
      const int b = owner_.get(next, -1);
      if (a < 0 || b < 0 || a == b || areNear(a, b)) continue;
      const int first = size();
      addNode(terrain, cells.centre(cell));
      addNode(terrain, cells.centre(next));
      link(a, first);
      link(first, first + 1);
      link(first + 1, b);
    }
  }
}

// Dijkstra's search; the first step towards each waypoint is handed on along the ways.
void WaypointGraph::searchFrom(int source) {
  using Open = std::pair<float, int>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> queue;
  distance_[pair(source, source)] = 0.0F;
  queue.emplace(0.0F, source);
  while (!queue.empty()) {
    const auto [length, node] = queue.top();
    queue.pop();
    if (length > distance_[pair(source, node)]) continue;
    for (const Edge& edge : edges_[static_cast<std::size_t>(node)]) {
      const float sum = length + edge.length;
      if (sum >= distance_[pair(source, edge.to)]) continue;
      distance_[pair(source, edge.to)] = sum;
      next_[pair(source, edge.to)] = node == source ? static_cast<std::uint16_t>(edge.to) : next_[pair(source, node)];
      queue.emplace(sum, edge.to);
    }
  }
}

void WaypointGraph::appendWay(int from, int to, std::vector<int>& way) const {
  while (from != to) {
    from = next_[pair(from, to)];
    way.push_back(from);
  }
}

}  // namespace frontier_pilot::bench
