#include "frontier_pilot/occupancy/occupancy_map.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "frontier_pilot/grids/growing_grid.h"
#include "occupancy/log_odds.h"
#include "occupancy/octree_file.h"
#include "occupancy/octree_layer.h"
#include "occupancy/tile_walk.h"

namespace frontier_pilot::occupancy {

LogOddsModel::LogOddsModel(const OccupancyModel& model)
    : hit(logOdds(model.hit)),
      miss(logOdds(model.miss)),
      min(logOdds(model.clamp_min)),
      max(logOdds(model.clamp_max)) {}

OccupancyMap::OccupancyMap(const OccupancyMapParameters& parameters)
    : parameters_(parameters), model_(parameters.model) {
  geometry_.resolution = parameters.resolution;
}
OccupancyMap::~OccupancyMap() = default;
OccupancyMap::OccupancyMap(OccupancyMap&&) noexcept = default;
OccupancyMap& OccupancyMap::operator=(OccupancyMap&&) noexcept = default;

void OccupancyMap::beginScan() {
  // The numbers of earlier scans do not matter any more: they are kept only while they are few.
  constexpr std::size_t kMostKept = 1024;  // [tiles]: 8 MB, or 100 m x 100 m in cells of 5 cm
  if (++scan_ != 0 && scans_.tileCount() <= kMostKept) return;
  scans_.clear();
  scan_ = 1;
}

float* OccupancyMap::roomFor(Cell in_frame) {
  if (float* known = log_odds_.find(in_frame)) return known;
  if (log_odds_.tileCount() < mostTiles()) return &log_odds_.at(in_frame);
  full_ = true;
  return nullptr;
}

void OccupancyMap::change(Cell in_frame, float step) {
  float* log_odds = roomFor(in_frame);
  if (log_odds == nullptr) return;
  const float prior = *log_odds;
  *log_odds = model_.clamp((prior == kUnknownLogOdds ? 0.0F : prior) + step);
  if (value(prior) == value(*log_odds)) return;
  const Cell cell{in_frame.x - extent_.x, in_frame.y - extent_.y};
  changes_.cells.include(cell);
  if (!grid_.empty()) outdated_.include(cell);
}

std::int8_t OccupancyMap::value(float log_odds) const {
  if (!parameters_.probabilities) return trinary(log_odds);
  if (log_odds == kUnknownLogOdds) return kUnknown;
  return static_cast<std::int8_t>(std::lround(100.0 * probability(log_odds)));
}

void OccupancyMap::project(const CellRect& cells, std::int8_t* out, std::ptrdiff_t stride) const {
  const Cell low = inFrame({cells.x, cells.y});
  const CellRect wanted{low.x, low.y, cells.width, cells.height};
  forEachTile(wanted, [&](Cell tile_low) {
    const Tiles::Tile* tile = log_odds_.tile(tile_low);
    const CellRect part = wanted.intersection({tile_low.x, tile_low.y, Tiles::kSide, Tiles::kSide});
    for (int y = part.y; y < part.y + part.height; ++y) {
      std::int8_t* row = out + (y - low.y) * stride + (part.x - low.x);
      if (tile == nullptr) {
        std::fill_n(row, part.width, kUnknown);
        continue;
      }
      const float* in = tile->data() + std::ptrdiff_t{y - tile_low.y} * Tiles::kSide + (part.x - tile_low.x);
      if (parameters_.probabilities) {
        std::transform(in, in + part.width, row, [this](float log_odds) { return value(log_odds); });
      } else {
        std::transform(in, in + part.width, row, trinary);
      }
    }
  });
}

const OccupancyGrid& OccupancyMap::grid() const {
  if (grid_.geometry() != geometry_) {
    grid_ = projection();
  } else if (!outdated_.empty()) {
    project(outdated_, grid_.row(outdated_.y) + outdated_.x, grid_.width());
  }
  outdated_ = {};
  return grid_;
}

OccupancyGrid OccupancyMap::projection(const CellRect& cells) const {
  GridGeometry geometry = geometry_;
  geometry.origin += Vec2(cells.x, cells.y) * geometry_.resolution;
  geometry.width = cells.width;
  geometry.height = cells.height;
  OccupancyGrid grid(geometry, kUnknown);
  project(cells, grid.row(0), grid.width());
  return grid;
}

bool OccupancyMap::hasOccupied() const {
  bool found = false;
  forEachTile(extent_, [&](Cell low) {
    const Tiles::Tile* tile = found ? nullptr : log_odds_.tile(low);
    if (tile == nullptr) return;
    found = std::any_of(tile->begin(), tile->end(), [this](float l) { return frontier_pilot::isOccupied(value(l)); });
  });
  return found;
}

OctreeLayer OccupancyMap::octree() const {
  OctreeLayer octree(parameters_.resolution, parameters_.scanner_height, parameters_.model);
  forEachTile(extent_, [&](Cell low) {
    const Tiles::Tile* tile = log_odds_.tile(low);
    for (std::size_t i = 0; tile != nullptr && i < tile->size(); ++i) {
      if ((*tile)[i] != kUnknownLogOdds) octree.set(cellOf(low, i), (*tile)[i]);
    }
  });
  return octree;
}

std::size_t OccupancyMap::memory() const { return log_odds_.memory() + scans_.memory(); }

MapChanges OccupancyMap::takeChanges() { return std::exchange(changes_, MapChanges{}); }

void OccupancyMap::clear() {
  log_odds_.clear();
  scans_.clear();
  full_ = false;
  changes_.cells = geometry_.rect();
  outdated_ = geometry_.rect();
}

CellRect OccupancyMap::changedFrom(const OccupancyMap& other) const {
  CellRect changed;
  forEachTile(extent_, [&](Cell low) {
    static const Tiles::Tile kNothing = [] {
      Tiles::Tile tile{};
      tile.fill(kUnknownLogOdds);
      return tile;
    }();
    const Tiles::Tile* ours = log_odds_.tile(low);
    const Tiles::Tile* theirs = other.log_odds_.tile(low);
    if (ours == theirs) return;  // neither is there
    const Tiles::Tile& now = ours != nullptr ? *ours : kNothing;
    const Tiles::Tile& then = theirs != nullptr ? *theirs : kNothing;
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (value(now[i]) == value(then[i])) continue;
      const Cell cell = cellOf(low, i);
      changed.include(Cell{cell.x - extent_.x, cell.y - extent_.y});
    }
  });
  return changed;
}

bool OccupancyMap::exchange(OccupancyMap& other) {
  CellRect cells = kept();
  cells.include(other.extent_);
  if (other.reserveCells(cells) != MapRoom::kEnough) return false;
  const bool grown = changes_.geometry_changed || other.geometry() != geometry();
  const CellRect differing = other.geometry() != geometry() ? other.geometry().rect() : changedFrom(other);
  CellRect changed = grown ? other.geometry().rect() : changes_.cells;
  changed.include(differing);
  std::swap(*this, other);
  changes_ = {grown, changed};
  grid_ = std::exchange(other.grid_, {});
  outdated_ = other.outdated_;
  outdated_.include(differing);
  return true;
}

void OccupancyMap::replaceBy(OccupancyMap& other) {
  clear();
  exchange(other);
}

std::size_t OccupancyMap::mostTiles() const {
  constexpr double kMega = 1e6;
  return static_cast<std::size_t>(kMega * parameters_.max_memory / sizeof(Tiles::Tile));
}

std::uint64_t OccupancyMap::mostNodes() const {
  // The nodes of a layer of as many cells as there is memory for and of the levels above it, and as many again for
  // other heights.
  const auto cells = static_cast<double>(mostTiles() * Tiles::kSide * Tiles::kSide);
  return static_cast<std::uint64_t>(2.0 * cells * 4.0 / 3.0);
}

std::size_t OccupancyMap::mostBytes() const {
  constexpr std::size_t kHeader = 4096;
  return kHeader + 2 * mostNodes();
}

bool OccupancyMap::read(const std::string& bytes, std::string& why) {
  const OctreeFile file = checkOctree(bytes, parameters_.resolution, mostNodes());
  why = file.problem;
  if (!file.ok()) return false;
  const OctreeLeaves leaves(file.tree, layerOf(parameters_));
  const CellRect cells = leaves.extent();
  // An octree without cells at the scanner's height is from another robot, and must not replace the map.
  if (cells.empty()) return why = "holds nothing at the scanner's height", false;
  OccupancyMap loaded(parameters_);
  why = describe(loaded.reserveCells(cells));
  if (!why.empty()) return false;
  leaves.forEach([&](const CellRect& leaf, bool occupied) {
    for (int y = leaf.y; y < leaf.y + leaf.height && !loaded.full_; ++y) {
      for (int x = leaf.x; x < leaf.x + leaf.width && !loaded.full_; ++x) {
        if (float* log_odds = loaded.roomFor({x, y})) *log_odds = occupied ? model_.max : model_.min;
      }
    }
  });
  if (loaded.full_) return why = describe(MapRoom::kNoMemory), false;
  why = describe(MapRoom::kTooLarge);
  return exchange(loaded);
}

bool OccupancyMap::write(std::ostream& out) const {
  return writeOctree(log_odds_, kUnknownLogOdds, layerOf(parameters_), parameters_.resolution, out);
}

bool OccupancyMap::logOdds(Cell cell, float& value) const {
  const float log_odds = log_odds_.get(inFrame(cell));
  if (log_odds == kUnknownLogOdds) return false;
  value = log_odds;
  return true;
}

}  // namespace frontier_pilot::occupancy
