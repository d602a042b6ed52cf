#include "frontier_pilot/slam/graph_slam.h"

#include <utility>

namespace frontier_pilot::slam {
namespace {

/// Whether a scan that was matched so shows what the map shows.
bool fits(MatchVerdict verdict) { return verdict != MatchVerdict::kPoor && verdict != MatchVerdict::kAmbiguous; }

bool isSound(const Track& track) {
  return track.verdict == MatchVerdict::kFirst || (track.verdict == MatchVerdict::kMatched && !track.slides);
}

void addPlace(const std::shared_ptr<const Submap>& submap, PlacedKeyframe& placed) {
  const bool inside = !submap->keyframes.empty() && submap->keyframes.back() == placed.keyframe.id;
  if (inside) placed.places.push_back({submap->id, submap->T_local_submap});
}

}  // namespace

GraphSlam::GraphSlam(const GraphSlamParameters& parameters, const occupancy::OccupancyMapParameters& map,
                     const occupancy::ScanInsertionParameters& insertion, std::string base)
    : parameters_(parameters),
      map_parameters_(map),
      insertion_parameters_(insertion),
      base_(std::move(base)),
      local_(parameters.local),
      drift_(parameters.local),
      back_end_(std::make_shared<GraphBackEnd>(parameters, map, insertion, base_)) {}

CorrectedScan GraphSlam::correct(const LaserScan2& scan, const Pose2& T_odom_base, const occupancy::OccupancyMap&) {
  LocalSlamOutput output = local_.update(scan, T_odom_base);
  if (output.keyframe) keep(output);
  const Track& track = output.track;
  return {T_map_local_ * track.T_local_base.pose * T_odom_base.inverse(), fits(track.verdict), describe(track),
          isSound(track)};
}

void GraphSlam::keep(LocalSlamOutput& output) {
  PlacedKeyframe placed;
  placed.keyframe = std::move(*output.keyframe);
  output.keyframe.reset();
  placed.drift = drift_.step(placed.keyframe, output.track.verdict);
  placed.T_map_base = T_map_local_ * placed.keyframe.T_local_base;
  for (const auto& submap : output.finished) addPlace(submap, placed);
  for (const auto& submap : local_.active()) addPlace(submap, placed);
  if (!placed.places.empty() && !abandoned_) inbox_.push_back(std::move(placed));
}

RevisionWork GraphSlam::takeWork() {
  if (working_ || inbox_.empty()) return {};
  working_ = true;
  auto batch = std::make_shared<std::vector<PlacedKeyframe>>(std::exchange(inbox_, {}));
  return [back_end = back_end_, batch, generation = generation_] {
    MapRevision revision = back_end->update(std::move(*batch));
    revision.generation = generation;
    return revision;
  };
}

bool GraphSlam::accept(const MapRevision& revision) {
  if (revision.generation != generation_) return false;
  working_ = false;
  T_map_local_ = revision.T_new_old * T_map_local_;
  // What came meanwhile is put into a map that was rendered anew at its new place.
  if (revision.map) {
    for (PlacedKeyframe& placed : inbox_) placed.T_map_base = revision.T_new_old * placed.T_map_base;
  }
  return true;
}

bool GraphSlam::refuse(const MapRevision& revision) {
  if (revision.generation != generation_) return false;
  working_ = false;
  back_end_->takeBack(revision);
  return true;
}

void GraphSlam::abandonWork() {
  working_ = false;
  abandoned_ = true;
  ++generation_;
  inbox_.clear();
}

void GraphSlam::reset() {
  abandoned_ = false;
  local_.reset();
  drift_.reset();
  T_map_local_ = Pose2();
  back_end_ = std::make_shared<GraphBackEnd>(parameters_, map_parameters_, insertion_parameters_, base_);
  inbox_.clear();
  working_ = false;
  ++generation_;
}

}  // namespace frontier_pilot::slam
