#include "frontier_pilot/slam/graph_slam.h"

#include <cstdint>
#include <optional>
#include <utility>

#include "slam/back_end/graph_back_end.h"
#include "slam/front_end/drift_covariance.h"
#include "slam/front_end/local_slam.h"

namespace frontier_pilot::slam {
namespace {

/// Whether a scan with this verdict may be inserted into the map.
bool fits(MatchVerdict verdict) {
  return verdict != MatchVerdict::kPoor && verdict != MatchVerdict::kAmbiguous && verdict != MatchVerdict::kKidnapped;
}

bool isSound(const Track& track) {
  return track.verdict == MatchVerdict::kFirst || (track.verdict == MatchVerdict::kMatched && !track.slides);
}

void addPlace(const std::shared_ptr<const Submap>& submap, PlacedKeyframe& placed) {
  const bool inside = !submap->keyframes.empty() && submap->keyframes.back() == placed.keyframe.id;
  if (inside) placed.places.push_back({submap->id, submap->T_local_submap});
}

/// The arguments that a GraphSlam was constructed with: a reset starts from them again.
struct Setup {
  GraphSlamParameters parameters;
  occupancy::OccupancyMapParameters map;
  occupancy::ScanInsertionParameters insertion;
  std::string base;

  std::shared_ptr<GraphBackEnd> backEnd() const {
    return std::make_shared<GraphBackEnd>(parameters, map, insertion, base);
  }
};

}  // namespace

struct GraphSlam::Impl {
  explicit Impl(Setup made_with)
      : setup(std::move(made_with)),
        local(setup.parameters.local, setup.parameters.surface),
        drift(setup.parameters.local),
        back_end(setup.backEnd()) {}

  void keep(LocalSlamOutput& output);
  KeyframeStep stepTo(const Keyframe& keyframe, const Track& track);

  Setup setup;
  LocalSlam local;
  DriftCovariance drift;
  std::optional<Pose2> T_local_keyframe;  ///< of the last keyframe
  Pose2 T_map_local;
  std::shared_ptr<GraphBackEnd> back_end;  ///< while work is under way, only that work accesses it
  std::vector<PlacedKeyframe> inbox;       ///< keyframes for the next work
  std::size_t kept = 0;                    ///< keyframes so far
  bool working = false;
  bool abandoned = false;  ///< the back end threw: it gets no more keyframes
  std::uint64_t generation = 0;
};

GraphSlam::GraphSlam(const GraphSlamParameters& parameters, const occupancy::OccupancyMapParameters& map,
                     const occupancy::ScanInsertionParameters& insertion, std::string base)
    : impl_(std::make_unique<Impl>(Setup{parameters, map, insertion, std::move(base)})) {}
GraphSlam::~GraphSlam() = default;

KeyframeStep GraphSlam::Impl::stepTo(const Keyframe& keyframe, const Track& track) {
  KeyframeStep step;
  if (T_local_keyframe) step.motion = T_local_keyframe->inverse() * keyframe.T_local_base;
  step.drift = drift.step(keyframe, track);
  step.weak = track.verdict == MatchVerdict::kExtended;
  T_local_keyframe = keyframe.T_local_base;
  return step;
}

void GraphSlam::Impl::keep(LocalSlamOutput& output) {
  PlacedKeyframe placed;
  placed.keyframe = std::move(*output.keyframe);
  output.keyframe.reset();
  placed.step = stepTo(placed.keyframe, output.track);
  placed.T_map_base = T_map_local * placed.keyframe.T_local_base;
  for (const auto& submap : output.finished) addPlace(submap, placed);
  for (const auto& submap : local.active()) addPlace(submap, placed);
  if (placed.places.empty() || abandoned) return;
  inbox.push_back(std::move(placed));
  ++kept;
}

CorrectedScan GraphSlam::correct(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base,
                                 const occupancy::OccupancyMap&) {
  LocalSlamOutput output = impl_->local.update(scan, T_odom_base);
  if (output.keyframe) impl_->keep(output);
  const Track& track = output.track;
  return {impl_->T_map_local * track.T_local_base.pose * T_odom_base.inverse(), fits(track.verdict), describe(track),
          isSound(track), track.verdict != MatchVerdict::kKidnapped};
}

Pose2 GraphSlam::withoutErrors(const Pose2& motion) const { return impl_->local.withoutErrors(motion); }

RevisionWork GraphSlam::takeWork() {
  if (impl_->working || impl_->inbox.empty()) return {};
  impl_->working = true;
  auto batch = std::make_shared<std::vector<PlacedKeyframe>>(std::exchange(impl_->inbox, {}));
  return [back_end = impl_->back_end, batch, generation = impl_->generation] {
    MapRevision revision = back_end->update(std::move(*batch));
    revision.generation = generation;
    return revision;
  };
}

bool GraphSlam::accept(const MapRevision& revision) {
  if (revision.generation != impl_->generation) return false;
  impl_->working = false;
  impl_->T_map_local = revision.T_new_old * impl_->T_map_local;
  // Scans that arrived meanwhile are inserted into the newly rendered map at their corrected poses.
  if (revision.map) {
    for (PlacedKeyframe& placed : impl_->inbox) placed.T_map_base = revision.T_new_old * placed.T_map_base;
  }
  return true;
}

bool GraphSlam::refuse(const MapRevision& revision) {
  if (revision.generation != impl_->generation) return false;
  impl_->working = false;
  impl_->back_end->takeBack(revision);
  return true;
}

std::vector<KeyframePose> GraphSlam::trajectory() const { return impl_->back_end->trajectory(); }
std::size_t GraphSlam::keyframes() const { return impl_->kept; }

void GraphSlam::abandonWork() {
  impl_->working = false;
  impl_->abandoned = true;
  ++impl_->generation;
  impl_->inbox.clear();
}

void GraphSlam::reset() {
  const std::uint64_t generation = impl_->generation + 1;
  impl_ = std::make_unique<Impl>(Setup(impl_->setup));
  impl_->generation = generation;
}

}  // namespace frontier_pilot::slam
