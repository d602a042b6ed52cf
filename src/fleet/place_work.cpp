// How the map merger looks for the places of robots whose starts are not known: when, with which maps, and what it
// takes to believe a match.
#include <cmath>
#include <memory>

#include "fleet/place_search.h"
#include "frontier_pilot/fleet/map_merger.h"

namespace frontier_pilot::fleet {
namespace {

constexpr double kPlaceSearchPeriod = 1.0;  // [s]
constexpr std::size_t kWindows = 6;         // of a search
constexpr int kEnoughWindows = 4;           // that lead to a place
constexpr int kEnoughSearches = 2;          // in which they do
constexpr double kEnoughOverlap = 20.0;     // [m^2]
constexpr double kWorthwhile = 0.01;        // correction of a place [m]
constexpr double kWorthwhileAngle = 0.002;  // [rad]

PlaceFinding find(PlaceFinding finding, const OccupancyGrid& a, const OccupancyGrid& b, std::size_t first,
                  const std::optional<Pose2>& T_a_b) {
  const PlaceSearch search(a, b);
  if (T_a_b) {
    if (const auto match = search.refine(*T_a_b)) finding.matches = {*match};
  } else {
    finding.matches = search.search(first, kWindows);
  }
  return finding;
}

/// Whether two transforms are the same but for the errors of a match.
bool areAlike(const PlaceMatch& one, const PlaceMatch& other) {
  constexpr double kDistance = 0.15;  // [m]
  constexpr double kAngle = 0.03;     // [rad]
  return (one.T_a_b.position() - other.T_a_b.position()).norm() < kDistance &&
         std::abs(angleDifference(one.T_a_b.yaw, other.T_a_b.yaw)) < kAngle;
}

}  // namespace

std::optional<PlaceWork> MapMerger::takeWork(Time now) {
  const bool waiting = last_search_ && now >= *last_search_ && now - *last_search_ < fromSeconds(kPlaceSearchPeriod);
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
    std::optional<Pose2> T_a_b;
    if (finding.refined) T_a_b = reference.T_map_robot->inverse() * *robot.T_map_robot;
    const std::size_t first = robot.next_window;
    robot.next_window += kWindows;
    searching_ = true;
    const auto a = std::make_shared<const OccupancyGrid>(reference.map());
    const auto b = std::make_shared<const OccupancyGrid>(robot.map());
    return [=] { return find(finding, *a, *b, first, T_a_b); };
  }
  return std::nullopt;
}

void MapMerger::accept(const PlaceFinding& finding, Time now) {
  searching_ = false;
  Robot& robot = robots_[finding.robot];
  if (!isMerged(finding.reference) || finding.matches.empty() || finding.refined != isMerged(finding.robot)) return;
  const Pose2& T_map_reference = *robots_[finding.reference].T_map_robot;
  if (finding.refined) {
    const Pose2 T_map_robot = T_map_reference * finding.matches.front().T_a_b;
    const Pose2 change = robot.T_map_robot->inverse() * T_map_robot;
    const bool worthwhile = change.position().norm() > kWorthwhile || std::abs(change.yaw) > kWorthwhileAngle;
    if (worthwhile) setPlace(finding.robot, T_map_robot, now);
    return;
  }
  weigh(robot, finding, T_map_reference);
  const bool sure = robot.status.windows >= kEnoughWindows && robot.searches >= kEnoughSearches &&
                    robot.candidate->agreement.overlap >= kEnoughOverlap;
  if (sure) setPlace(finding.robot, robot.candidate->T_a_b, now);
}

/// Counts what speaks for the robot's candidate. Another place that fits begins the count anew.
void MapMerger::weigh(Robot& robot, const PlaceFinding& finding, const Pose2& T_map_reference) {
  for (PlaceMatch match : finding.matches) {
    match.T_a_b = T_map_reference * match.T_a_b;
    if (!robot.candidate || !areAlike(*robot.candidate, match)) robot.status.windows = robot.searches = 0;
    robot.candidate = match;
    ++robot.status.windows;
  }
  ++robot.searches;
}

}  // namespace frontier_pilot::fleet
