#include "sim/disc_index.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::sim {
namespace {

constexpr double kBinSize = 2.0;  // [m]: most robots lie in one or two bins; a scan with a range of 8 m visits about 80

int bin(double metres, int count) {
  return static_cast<int>(std::clamp(std::floor(metres / kBinSize), 0.0, count - 1.0));
}

int binsAlong(int cells, double resolution) {
  return std::max(1, static_cast<int>(std::ceil(cells * resolution / kBinSize)));
}

}  // namespace

DiscIndex::DiscIndex(const GridGeometry& geometry)
    : bins_(GridGeometry{kBinSize, geometry.origin, binsAlong(geometry.width, geometry.resolution),
                         binsAlong(geometry.height, geometry.resolution)}) {}

CellRect DiscIndex::binsIn(const Vec2& low, const Vec2& high) const {
  const Vec2 origin = bins_.geometry().origin;
  const Cell first{bin(low.x() - origin.x(), bins_.width()), bin(low.y() - origin.y(), bins_.height())};
  const Cell last{bin(high.x() - origin.x(), bins_.width()), bin(high.y() - origin.y(), bins_.height())};
  return {first.x, first.y, last.x - first.x + 1, last.y - first.y + 1};
}

CellRect DiscIndex::binsOf(const Disc& disc) const {
  const Vec2 reach(disc.radius, disc.radius);
  return binsIn(disc.centre - reach, disc.centre + reach);
}

void DiscIndex::file(Id id) {
  const CellRect bins = binsOf(discs_[id]);
  for (int y = bins.y; y < bins.y + bins.height; ++y) {
    for (int x = bins.x; x < bins.x + bins.width; ++x) bins_[Cell{x, y}].push_back(id);
  }
}

void DiscIndex::unfile(Id id) {
  const CellRect bins = binsOf(discs_[id]);
  for (int y = bins.y; y < bins.y + bins.height; ++y) {
    for (int x = bins.x; x < bins.x + bins.width; ++x) {
      std::vector<Id>& ids = bins_[Cell{x, y}];
      ids.erase(std::find(ids.begin(), ids.end(), id));
    }
  }
}

DiscIndex::Id DiscIndex::add(const Disc& disc) {
  if (unused_.empty()) {
    unused_.push_back(static_cast<Id>(discs_.size()));
    discs_.emplace_back();
  }
  const Id id = unused_.back();
  unused_.pop_back();
  discs_[id] = disc;
  file(id);
  return id;
}

void DiscIndex::move(Id id, const Vec2& centre) {
  Disc& disc = discs_[id];
  const bool same_bins = binsOf(disc) == binsOf({centre, disc.radius});
  if (!same_bins) unfile(id);
  disc.centre = centre;
  if (!same_bins) file(id);
}

void DiscIndex::remove(Id id) {
  unfile(id);
  unused_.push_back(id);
}

}  // namespace frontier_pilot::sim
