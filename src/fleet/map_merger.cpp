#include "frontier_pilot/fleet/map_merger.h"

#include <algorithm>

namespace frontier_pilot::fleet {
namespace {

MergeState stateAfter(SourceResult result) {
  switch (result) {
    case SourceResult::kTaken:
      return MergeState::kMerged;
    case SourceResult::kOtherResolution:
      return MergeState::kOtherResolution;
    case SourceResult::kTooLarge:
      break;
  }
  return MergeState::kTooLarge;
}

/// The index of the map of `other` in the view of `robot`, whose own map has index 0.
std::size_t sourceIndex(std::size_t other, std::size_t robot) { return other < robot ? other + 1 : other; }

CellRect wholeOf(const OccupancyGrid& map) { return map.geometry().rect(); }

/// Whether `now` is not `before` as it has grown or was corrected, but a map that was begun anew, or loaded: much of
/// what was known is not known any more, or otherwise.
bool isAnotherMap(const OccupancyGrid& before, const OccupancyGrid& now) {
  constexpr double kLeastKept = 0.75;  // share of the cells that were known
  std::size_t known = 0;
  for (std::size_t i = 0; i < before.size(); ++i) known += before[i] == kUnknown ? 0 : 1;
  return static_cast<double>(compare(before, now, Pose2()).agreeing) < kLeastKept * static_cast<double>(known);
}

}  // namespace

const char* toString(MergeState state) {
  switch (state) {
    case MergeState::kNoMap:
      return "no map yet";
    case MergeState::kPlaceUnknown:
      return "its place is not known yet";
    case MergeState::kTooLargeToSearch:
      return "its place is not known, and not looked for: its map or the one to find it in is too large";
    case MergeState::kMerged:
      return "merged";
    case MergeState::kContradicted:
      return "left out: its walls contradict the free space of others";
    case MergeState::kOtherResolution:
      return "left out: its cells have another size";
    case MergeState::kTooLarge:
      break;
  }
  return "left out: the map would become too large";
}

MapMerger::MapMerger(const MapMergerParameters& parameters)
    : parameters_(parameters), robots_(parameters.robots.size()) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (i == 0) {
      robots_[i].T_map_robot = Pose2();
    } else if (parameters.known_starts) {
      robots_[i].T_map_robot = parameters.robots[0].start().inverse() * parameters.robots[i].start();
    }
  }
}

void MapMerger::setMap(std::size_t robot, const OccupancyGrid& map, const CellRect& changed, Time now) {
  Robot& own = robots_[robot];
  noticeAnotherMap(robot, map, changed, now);
  const bool same_extent = own.hasMap() && own.map().geometry() == map.geometry();
  const std::vector<CellRect> parts = own.snapshot.take(map, changed);
  if (same_extent && parts.empty()) return;
  if (own.view.setSourceParts(0, own.map(), parts, {}) != SourceResult::kTaken) {
    withdraw(robot);  // the robot's own map comes before those of others
    own.view.setSource(0, own.map(), wholeOf(own.map()), {});
  }
  share(robot, parts, now);
}

void MapMerger::setPlace(std::size_t robot, const std::optional<Pose2>& T_map_robot, Time now) {
  if (robot == 0) return;
  robots_[robot].T_map_robot = T_map_robot;
  robots_[robot].contradicted = false;
  if (robots_[robot].hasMap()) share(robot, {}, now);
}

void MapMerger::share(std::size_t robot, const std::vector<CellRect>& changed, Time now) {
  const Robot& own = robots_[robot];
  if (!own.T_map_robot || own.contradicted) {
    withdraw(robot);
    return enter(robot, own.contradicted ? MergeState::kContradicted : own.unplaced, now);
  }
  const bool was_merged = isMerged(robot);
  const SourceResult result = common_.setSourceParts(robot, own.map(), changed, *own.T_map_robot);
  if (result != SourceResult::kTaken) withdraw(robot);
  enter(robot, stateAfter(result), now);
  if (!isMerged(robot)) return;
  for (std::size_t other = 0; other < robots_.size(); ++other) {
    if (other == robot || !isMerged(other)) continue;
    show(robot, other, changed);
    if (!was_merged || changed.empty()) show(other, robot, {});
  }
}

void MapMerger::withdraw(std::size_t robot) {
  common_.removeSource(robot);
  for (std::size_t other = 0; other < robots_.size(); ++other) {
    if (other == robot) continue;
    robots_[other].view.removeSource(sourceIndex(robot, other));
    robots_[robot].view.removeSource(sourceIndex(other, robot));
  }
}

void MapMerger::show(std::size_t other, std::size_t robot, const std::vector<CellRect>& changed) {
  const Pose2 T_robot_other = robots_[robot].T_map_robot->inverse() * *robots_[other].T_map_robot;
  robots_[robot].view.setSourceParts(sourceIndex(other, robot), robots_[other].map(), changed, T_robot_other);
}

void MapMerger::enter(std::size_t robot, MergeState state, Time now) {
  MergeStatus& status = robots_[robot].status;
  if (status.state != state) status.since = now;
  status.state = state;
}

void MapMerger::update(Time now) {
  const bool waiting = last_check_ && now >= *last_check_ && now - *last_check_ < fromSeconds(parameters_.check_period);
  if (waiting || robots_.size() < 2) return;
  last_check_ = now;
  next_check_ = next_check_ % (robots_.size() - 1) + 1;
  judge(next_check_, now);
}

void MapMerger::judge(std::size_t robot, Time now) {
  Robot& own = robots_[robot];
  if (!isMerged(robot) && !own.contradicted) return;
  Agreement agreement;
  for (std::size_t other = 0; other < robot; ++other) {
    if (!isMerged(other)) continue;
    agreement += compare(robots_[other].map(), own.map(), robots_[other].T_map_robot->inverse() * *own.T_map_robot);
  }
  own.status.agreement = agreement;
  // A place that was found, and not given, may belong to another room of the same shape.
  constexpr double kMostOfAFoundPlace = 0.12;
  const double most = parameters_.known_starts ? parameters_.max_contradicted
                                               : std::min(kMostOfAFoundPlace, parameters_.max_contradicted);
  const double limit = own.contradicted ? 0.5 * most : most;
  const bool contradicted = agreement.contradictedShare() > limit;
  if (contradicted == own.contradicted) return;
  own.contradicted = contradicted;
  if (contradicted && !parameters_.known_starts) return forgetPlace(robot, now);
  share(robot, {wholeOf(own.map())}, now);
}

void MapMerger::Robot::forgetWindows() {
  for (auto& [reference, look] : looks) look.windows = {};
  status.windows = 0;
}

void MapMerger::forgetPlace(std::size_t robot, Time now) {
  robots_[robot].candidate.reset();
  robots_[robot].forgetWindows();
  setPlace(robot, std::nullopt, now);
}

/// The places of all are in the frame of the first robot's map.
void MapMerger::noticeAnotherMap(std::size_t robot, const OccupancyGrid& map, const CellRect& changed, Time now) {
  const Robot& own = robots_[robot];
  if (parameters_.known_starts || !own.hasMap()) return;
  const bool may_be =
      own.map().geometry() != map.geometry() || 2L * changed.width * changed.height >= static_cast<long>(map.size());
  if (!may_be || !isAnotherMap(own.map(), map)) return;
  if (robot != 0) return forgetPlace(robot, now);
  for (std::size_t other = 1; other < robots_.size(); ++other) forgetPlace(other, now);
}

std::optional<Pose2> MapMerger::place(std::size_t robot) const {
  return isMerged(robot) ? robots_[robot].T_map_robot : std::nullopt;
}

}  // namespace frontier_pilot::fleet
