#include "frontier_pilot/scan_matching/surface_map.h"

#include <vector>

#include "scan_matching/likelihood_grid.h"
#include "scan_matching/surfel_map.h"

namespace frontier_pilot::scan_matching {
namespace {

std::vector<Vec2> positionsOf(const surfaces::SurfacePoints& points, const Pose2& T_map_points) {
  std::vector<Vec2> positions;
  positions.reserve(points.size());
  for (const surfaces::SurfacePoint& point : points) positions.push_back(T_map_points * point.position);
  return positions;
}

}  // namespace

struct SurfaceMap::Impl {
  explicit Impl(const LikelihoodParameters& parameters) : likelihood(parameters) {}

  LikelihoodGrid likelihood;
  SurfelMap surfels;
};

SurfaceMap::SurfaceMap(const LikelihoodParameters& parameters) : impl_(std::make_unique<Impl>(parameters)) {}
SurfaceMap::~SurfaceMap() = default;
SurfaceMap::SurfaceMap(SurfaceMap&&) noexcept = default;
SurfaceMap& SurfaceMap::operator=(SurfaceMap&&) noexcept = default;

void SurfaceMap::add(const surfaces::SurfacePoints& points, const Pose2& T_map_points) {
  impl_->likelihood.add(positionsOf(points, T_map_points));
  impl_->surfels.add(points, T_map_points);
}

void SurfaceMap::updateKnown(const surfaces::SurfacePoints& points, const Pose2& T_map_points) {
  impl_->surfels.updateKnown(points, T_map_points);
}

const Grid<std::uint8_t>& SurfaceMap::field() const { return impl_->likelihood.grid(); }

const SurfelMap& SurfaceMap::surfels() const { return impl_->surfels; }

std::size_t SurfaceMap::memory() const { return field().size() + impl_->surfels.memory(); }

Grid<std::uint8_t> likelihoodField(const surfaces::SurfacePoints& points, const LikelihoodParameters& parameters) {
  LikelihoodGrid likelihood(parameters);
  likelihood.add(positionsOf(points, Pose2()));
  return likelihood.grid();
}

}  // namespace frontier_pilot::scan_matching
