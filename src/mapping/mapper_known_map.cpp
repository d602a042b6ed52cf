#include <optional>
#include <string>
#include <utility>

#include "mapping/corrections.h"
#include "mapping/mapper_impl.h"

namespace frontier_pilot::mapping {

bool Mapper::load(occupancy::OccupancyMap& loaded) {
  if (!canBeKnown(loaded, impl_->parameters)) return false;
  impl_->map.replaceBy(loaded);
  ++impl_->generation;
  const std::optional<Pose2> T_odom_base = impl_->last ? std::make_optional(impl_->last->pose) : std::nullopt;
  impl_->lookFor(beliefOf(impl_->T_map_odom * T_odom_base.value_or(Pose2())), T_odom_base);
  return true;
}

bool Mapper::resume(occupancy::OccupancyMap& map, const Pose2& T_map_odom, const Pose2& T_odom_base,
                    bool was_localized) {
  // If odometry has been trusted since the first scan, it still is.
  const bool trusted =
      impl_->parameters.trust_odometry && !impl_->parameters.localize_only && was_localized && T_map_odom == Pose2();
  if (!trusted && !canBeKnown(map, impl_->parameters)) return false;
  impl_->map.replaceBy(map);
  ++impl_->generation;
  impl_->T_map_odom = T_map_odom;
  if (!trusted) impl_->lookFor(beliefOf(T_map_odom * T_odom_base), T_odom_base);
  return true;
}

std::string Mapper::whyNotFound() const {
  if (!map().hasOccupied()) return "the map has no occupied cell yet, so the robot cannot be found in it";
  if (!canBeKnown(map(), impl_->parameters))
    return "the map is too large for the robot to be found in it, see docs/limits.md";
  return {};
}

bool Mapper::locate(const scan_matching::PoseWithCovariance& T_map_base) {
  if (!whyNotFound().empty()) return false;
  impl_->lookFor(T_map_base, std::nullopt);
  return true;
}

std::function<RobotSearch()> Mapper::searchWork(const std::function<bool()>& stop) const {
  if (!canBeKnown(map(), impl_->parameters))
    return [] { return RobotSearch{{localization::SearchVerdict::kTooLarge, {}, {}}, {}, 0}; };
  return impl_->recent.searchOn(map().projection(), impl_->generation, impl_->parameters.slam, stop);
}

bool Mapper::locate(const RobotSearch& search) {
  const bool is_void = search.generation != impl_->generation || !impl_->last;
  if (!search.found() || is_void || !whyNotFound().empty()) return false;
  const Pose2 T_map_odom = search.result.best.T_map_base * search.T_odom_base.inverse();
  const Eigen::Vector3d sigma(0.1, 0.1, 0.05);  // [m, m, rad]
  impl_->lookFor({T_map_odom * impl_->last->pose, sigma.cwiseAbs2().asDiagonal()}, impl_->last->pose);
  return true;
}

void Mapper::Impl::lookFor(const scan_matching::PoseWithCovariance& T_map_base,
                           const std::optional<Pose2>& T_odom_base) {
  replace(knownMap(parameters, map, T_map_base, T_odom_base));
  localization.lookFor(map.hasOccupied());
}

void Mapper::Impl::replace(std::unique_ptr<slam::PoseCorrection> corrector) {
  correction = std::move(corrector);
  ++epoch;
  forgetEarlierPoses();
}

}  // namespace frontier_pilot::mapping
