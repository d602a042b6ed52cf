// How the map merger looks for the places of robots whose starts are not known: when, with which maps, and what it
// takes to believe a match.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>

#include "fleet/lattice.h"
#include "fleet/place/place_search.h"
#include "frontier_pilot/fleet/map_merger.h"

namespace frontier_pilot::fleet {
namespace {

constexpr double kPause = 2.0;              // from the end of a search to the next, which may be a second of CPU [s]
constexpr std::size_t kWindows = 12;        // of a search
constexpr int kEnoughWindows = 2;           // of either map that lead to a place
constexpr double kEnoughOverlap = 25.0;     // [m^2]
constexpr double kMostDoubt = 0.01;         // share of the walls in free space: 0 at most true places
constexpr double kWorthwhile = 0.01;        // correction of a place [m]
constexpr double kWorthwhileAngle = 0.002;  // [rad]

PlaceFinding find(PlaceFinding finding, const OccupancyGrid& a, const OccupancyGrid& b,
                  const std::optional<Pose2>& T_a_b, const std::function<bool()>& stop) {
  if (finding.refined) {
    if (const auto match = PlaceSearch(a, b, stop).refine(*T_a_b)) finding.matches = {*match};
    return finding;
  }
  WindowRound round{kWindows, finding.last_window, T_a_b};
  if (finding.reversed && T_a_b) round.T_a_b_guess = T_a_b->inverse();
  finding.matches = finding.reversed ? PlaceSearch(b, a, stop).search(round) : PlaceSearch(a, b, stop).search(round);
  finding.last_window = round.after;
  if (!finding.reversed) return finding;
  for (PlaceMatch& match : finding.matches) match.T_a_b = match.T_a_b.inverse();
  return finding;
}

/// Whether so many windows of either map, and what both maps know, leave no doubt about a place.
bool isSure(const std::array<int, 2>& windows, const PlaceMatch& match) {
  return windows[0] >= kEnoughWindows && windows[1] >= kEnoughWindows && match.agreement.overlap >= kEnoughOverlap &&
         match.agreement.contradictedShare() <= kMostDoubt;
}

/// Whether two transforms are the same but for the errors of a match.
bool areAlike(const PlaceMatch& one, const PlaceMatch& other) {
  constexpr double kDistance = 0.15;  // [m]
  constexpr double kAngle = 0.03;     // [rad]
  return areNear(one.T_a_b, other.T_a_b, kDistance, kAngle);
}

}  // namespace

std::optional<PlaceWork> MapMerger::takeWork(Time now, const std::function<bool()>& stop) {
  const bool waiting = last_search_ && now >= *last_search_ && now - *last_search_ < fromSeconds(kPause);
  if (parameters_.known_starts || searching_ || waiting || robots_.size() < 2) return std::nullopt;
  last_search_ = now;
  const std::size_t pairs = robots_.size() * robots_.size();
  for (std::size_t tried = 0; tried < pairs; ++tried) {
    next_search_ = (next_search_ + 1) % pairs;
    PlaceFinding finding;
    finding.robot = next_search_ / robots_.size();
    finding.reference = next_search_ % robots_.size();
    Robot& robot = robots_[finding.robot];
    const Robot& reference = robots_[finding.reference];
    finding.refined = isMerged(finding.robot);
    const bool later = finding.refined ? finding.reference < finding.robot : finding.reference != finding.robot;
    if (finding.robot == 0 || !later || !robot.hasMap() || !isMerged(finding.reference)) continue;
    if (!mayBeSearched(finding, now)) return std::nullopt;
    std::optional<Pose2> T_map_b = robot.T_map_robot;
    if (!finding.refined && robot.candidate) T_map_b = robot.candidate->T_a_b;
    std::optional<Pose2> T_a_b;
    if (T_map_b) T_a_b = reference.T_map_robot->inverse() * *T_map_b;
    Look& look = robot.looks[finding.reference];
    look.reversed = !look.reversed;
    finding.reversed = look.reversed;
    finding.last_window = look.last_window[look.reversed ? 1 : 0];
    const auto a = std::make_shared<const OccupancyGrid>(reference.map());
    const auto b = std::make_shared<const OccupancyGrid>(robot.map());
    searching_ = true;  // there was memory for the copies
    return [=] { return find(finding, *a, *b, T_a_b, stop); };
  }
  return std::nullopt;
}

/// Whether the two maps can be searched; if not, the robot's state says why.
bool MapMerger::mayBeSearched(const PlaceFinding& finding, Time now) {
  Robot& robot = robots_[finding.robot];
  const OccupancyGrid& reference = robots_[finding.reference].map();
  const MergeState state = !sameResolution(reference.geometry(), robot.map().geometry()) ? MergeState::kOtherResolution
                           : !(canBeSearched(reference) && canBeSearched(robot.map()))   ? MergeState::kTooLargeToSearch
                                                                                         : MergeState::kPlaceUnknown;
  const bool may = state == MergeState::kPlaceUnknown;
  if (may) {
    robot.not_searched.erase(finding.reference);
  } else {
    robot.not_searched.insert(finding.reference);
  }
  bool anywhere = false;  // it is looked for in the map of one robot at least, or will be
  for (std::size_t other = 0; other < robots_.size(); ++other)
    anywhere |= other != finding.robot && isMerged(other) && robot.not_searched.count(other) == 0;
  robot.unplaced = anywhere ? MergeState::kPlaceUnknown : state;
  if (!finding.refined) enter(finding.robot, robot.unplaced, now);
  return may;
}

void MapMerger::accept(const PlaceFinding& finding, Time now) {
  searching_ = false;
  last_search_ = now;
  Robot& robot = robots_[finding.robot];
  Look& look = robot.looks[finding.reference];
  look.last_window[finding.reversed ? 1 : 0] = finding.last_window;
  if (!isMerged(finding.reference) || finding.refined != isMerged(finding.robot)) return;
  const Pose2& T_map_reference = *robots_[finding.reference].T_map_robot;
  if (finding.refined) {
    if (finding.matches.empty()) return;
    const Pose2 T_map_robot = T_map_reference * finding.matches.front().T_a_b;
    const Pose2 change = robot.T_map_robot->inverse() * T_map_robot;
    const bool worthwhile = change.position().norm() > kWorthwhile || std::abs(change.yaw) > kWorthwhileAngle;
    if (worthwhile) setPlace(finding.robot, T_map_robot, now);
    return;
  }
  weigh(robot, finding, T_map_reference);
  if (robot.candidate && isSure(look.windows, *robot.candidate)) setPlace(finding.robot, robot.candidate->T_a_b, now);
}

/// Counts what the last searches in either direction say for the robot's candidate. Another place that fits begins the
/// count anew.
void MapMerger::weigh(Robot& robot, const PlaceFinding& finding, const Pose2& T_map_reference) {
  int& windows = robot.looks[finding.reference].windows[finding.reversed ? 1 : 0];
  windows = 0;
  for (PlaceMatch match : finding.matches) {
    match.T_a_b = T_map_reference * match.T_a_b;
    if (!robot.candidate || !areAlike(*robot.candidate, match)) robot.forgetWindows();
    robot.candidate = match;
    ++windows;
  }
  robot.status.windows = 0;
  for (const auto& [reference, look] : robot.looks)
    robot.status.windows = std::max(robot.status.windows, look.allWindows());
}

}  // namespace frontier_pilot::fleet
