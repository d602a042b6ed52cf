#include "frontier_pilot/occupancy/occupancy_map.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "frontier_pilot/grids/growing_grid.h"
#include "occupancy/log_odds.h"
#include "occupancy/octree_layer.h"

namespace frontier_pilot::occupancy {

LogOddsModel::LogOddsModel(const OccupancyModel& model)
    : hit(logOdds(model.hit)),
      miss(logOdds(model.miss)),
      min(logOdds(model.clamp_min)),
      max(logOdds(model.clamp_max)) {}

OccupancyMap::OccupancyMap(const OccupancyMapParameters& parameters)
    : parameters_(parameters),
      model_(parameters.model),
      octree_(std::make_unique<OctreeLayer>(parameters.resolution, parameters.scanner_height, parameters.model)) {}
OccupancyMap::~OccupancyMap() = default;
OccupancyMap::OccupancyMap(OccupancyMap&&) noexcept = default;
OccupancyMap& OccupancyMap::operator=(OccupancyMap&&) noexcept = default;

CellRect OccupancyMap::needed(const Vec2& low, const Vec2& high) const {
  GridGeometry frame;
  frame.resolution = parameters_.resolution;
  CellRect cells = extent_;
  // One cell more on each side: a point on a border may be rounded to either cell.
  const Cell first = frame.cellAt(low);
  const Cell last = frame.cellAt(high);
  cells.include(Cell{first.x - 1, first.y - 1});
  cells.include(Cell{last.x + 1, last.y + 1});
  return cells;
}

bool OccupancyMap::reserve(const Vec2& low, const Vec2& high) {
  // Far beyond any map, so that what follows cannot overflow; the comparison is also false for NaN.
  constexpr double kFar = 1e6;  // [m]
  const bool near = low.cwiseAbs().maxCoeff() < kFar && high.cwiseAbs().maxCoeff() < kFar;
  return near && reserveCells(needed(low, high));
}

CellRect OccupancyMap::snapped(const CellRect& cells) const {
  const int step = std::max(1, static_cast<int>(std::lround(parameters_.growth_step / parameters_.resolution)));
  return grids::snap(cells, step);
}

bool OccupancyMap::isAllowed(const CellRect& snapped) const {
  const int limit = static_cast<int>(parameters_.max_side / parameters_.resolution);
  if (snapped.width > limit || snapped.height > limit) return false;
  constexpr int kHalf = OctreeLayer::kHalfSide;
  return snapped.intersection({-kHalf, -kHalf, 2 * kHalf, 2 * kHalf}) == snapped;
}

bool OccupancyMap::reserveCells(const CellRect& cells) {
  if (cells == extent_) return true;
  const CellRect grown = snapped(cells);
  if (!isAllowed(grown)) return false;
  resize(grown);
  return true;
}

void OccupancyMap::resize(const CellRect& cells) {
  if (cells == extent_) return;
  GridGeometry geometry;
  geometry.resolution = parameters_.resolution;
  geometry.origin = Vec2(cells.x, cells.y) * parameters_.resolution;
  geometry.width = cells.width;
  geometry.height = cells.height;
  const Cell offset{extent_.x - cells.x, extent_.y - cells.y};
  entries_ = grids::resized(entries_, geometry, offset, Entry{});
  grid_ = grids::resized(grid_, geometry, offset, kUnknown);
  extent_ = cells;
  changes_ = {true, geometry.rect()};
}

void OccupancyMap::beginScan() { ++scan_; }

void OccupancyMap::change(std::size_t index, float step) {
  Entry& entry = entries_[index];
  const float prior = entry.log_odds == kUnknownLogOdds ? 0.0F : entry.log_odds;
  entry.log_odds = model_.clamp(prior + step);
  if (!in_batch_) store(index);
  project(index, entry.log_odds);
}

void OccupancyMap::store(std::size_t index) {
  const Cell cell = geometry().cell(index);
  octree_->set({cell.x + extent_.x, cell.y + extent_.y}, entries_[index].log_odds);
}

void OccupancyMap::endBatch() {
  in_batch_ = false;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].log_odds != kUnknownLogOdds) store(i);
  }
}

void OccupancyMap::project(std::size_t index, float log_odds) {
  const std::int8_t projected = value(log_odds);
  if (grid_[index] == projected) return;
  grid_[index] = projected;
  changes_.cells.include(geometry().cell(index));
}

std::int8_t OccupancyMap::value(float log_odds) const {
  if (parameters_.probabilities) return static_cast<std::int8_t>(std::lround(100.0 * probability(log_odds)));
  return log_odds >= 0.0F ? kOccupied : kFree;
}

MapChanges OccupancyMap::takeChanges() { return std::exchange(changes_, MapChanges{}); }

void OccupancyMap::clear() {
  octree_->clear();
  std::fill(entries_.cells().begin(), entries_.cells().end(), Entry{});
  std::fill(grid_.cells().begin(), grid_.cells().end(), kUnknown);
  changes_.cells = geometry().rect();
}

bool OccupancyMap::hasRoomFor(const OccupancyMap& other) const {
  CellRect cells = extent_;
  cells.include(other.extent_);
  return cells == other.extent_ || isAllowed(other.snapped(cells));
}

bool OccupancyMap::exchange(OccupancyMap& other) {
  CellRect cells = extent_;
  cells.include(other.extent_);
  if (!other.reserveCells(cells)) return false;
  const bool grown = changes_.geometry_changed || other.geometry() != geometry();
  CellRect changed = changes_.cells;
  changed.include(grown ? other.geometry().rect() : difference(grid_, other.grid_));
  std::swap(*this, other);
  changes_ = {grown, changed};
  return true;
}

std::uint64_t OccupancyMap::mostNodes() const {
  // The nodes of a layer whose cells are all known and of the levels above it, and as many again for other heights.
  const double side = parameters_.max_side / parameters_.resolution;
  return static_cast<std::uint64_t>(2.0 * side * side * 4.0 / 3.0);
}

std::size_t OccupancyMap::mostBytes() const {
  constexpr std::size_t kHeader = 4096;
  return kHeader + 2 * mostNodes();
}

bool OccupancyMap::read(const std::string& bytes, std::string& why) {
  OccupancyMap loaded(parameters_);
  why = loaded.octree_->read(bytes, mostNodes());
  if (!why.empty()) return false;
  const CellRect cells = loaded.octree_->extent();
  // An octree without cells at the scanner's height is from another robot, and must not replace the map.
  if (cells.empty()) return why = "holds nothing at the scanner's height", false;
  why = "is larger than the map may be";
  if (!loaded.reserveCells(cells)) return false;
  loaded.octree_->forEach([&](Cell cell, float log_odds) {
    const std::size_t index = loaded.geometry().index({cell.x - loaded.extent_.x, cell.y - loaded.extent_.y});
    loaded.entries_[index].log_odds = log_odds;
    loaded.grid_[index] = loaded.value(log_odds);
  });
  return exchange(loaded);
}

bool OccupancyMap::write(std::ostream& out) { return octree_->write(out); }

bool OccupancyMap::logOdds(Cell cell, float& value) const {
  const Entry entry = entries_.get(cell, Entry{});
  if (entry.log_odds == kUnknownLogOdds) return false;
  value = entry.log_odds;
  return true;
}

}  // namespace frontier_pilot::occupancy
