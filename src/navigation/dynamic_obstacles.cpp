#include "navigation/dynamic_obstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace frontier_pilot::navigation {
namespace {

constexpr double kNear = 4.0;           ///< farther things are not followed [m]
constexpr double kOffWalls = 0.15;      ///< least distance from what the map shows [m]
constexpr double kSameThing = 0.25;     ///< between neighbouring hits of one thing [m]
constexpr std::size_t kFewestHits = 3;  ///< of a thing
constexpr double kWidest = 1.2;         ///< a group that is wider is no thing that drives or walks [m]
constexpr double kThinnest = 0.1;       ///< least radius that a thing is given, as its far side is not seen [m]
constexpr double kSameTrack = 0.35;     ///< between where a thing is expected and where it is seen [m]
constexpr double kLookBack = 0.8;       ///< velocities are those of this time [s]
constexpr double kShortestTrack = 0.3;  ///< that gives a velocity [s]
constexpr double kLost = 0.6;           ///< a thing that was not seen for longer is another one [s]
constexpr double kSlowestThing = 0.12;  ///< of a thing that counts as moving [m/s]
constexpr double kFastestThing = 2.0;   ///< faster ones are different things that were taken for one [m/s]
constexpr double kOldest = 1.0;         ///< what was last seen before that is nowhere any more [s]
constexpr std::size_t kMostTracks = 50;

/// Neighbouring hits where the map knows the floor to be free.
struct Group {
  Vec2 first = Vec2::Zero(), last = Vec2::Zero();
  std::size_t first_beam = 0, last_beam = 0;
  std::size_t hits = 0;

  double extent() const { return (last - first).norm(); }
};

/// When a beam was measured, as far before the scan's stamp as the scanner needed to reach the last beam.
Time timeOf(const LaserScan2& scan, double beam) {
  const double left = scan.reversed ? beam : static_cast<double>(scan.ranges.size()) - 1.0 - beam;
  return scan.stamp - fromSeconds(left * scan.time_increment);
}

std::vector<Group> groupsIn(const LaserScan2& scan, const Pose2& T_map_base, const planning::ClearanceMap& map) {
  const int off_walls = static_cast<int>(std::ceil(kOffWalls / map.geometry().resolution));
  std::vector<Group> groups;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const RangeReading reading = readBeam(scan, beam);
    if (reading.kind != RangeKind::kHit || reading.distance > kNear) continue;
    const Vec2 point = T_map_base * scan.point(beam, reading.distance);
    const Cell cell = map.geometry().cellAt(point);
    if (!map.isKnownFree(cell) || map.isMapOccupiedNear(cell, off_walls)) continue;
    if (groups.empty() || (groups.back().last - point).norm() > kSameThing)
      groups.push_back({point, point, beam, beam, 0});
    groups.back().last = point;
    groups.back().last_beam = beam;
    ++groups.back().hits;
  }
  return groups;
}

}  // namespace

std::vector<DynamicObstacles::Sight> DynamicObstacles::sightsIn(const LaserScan2& scan, const Pose2& T_map_base,
                                                                const planning::ClearanceMap& map) {
  std::vector<Sight> sights;
  for (const Group& group : groupsIn(scan, T_map_base, map)) {
    if (group.hits < kFewestHits || group.extent() > kWidest) continue;
    const double middle = 0.5 * static_cast<double>(group.first_beam + group.last_beam);
    sights.push_back(
        {timeOf(scan, middle), 0.5 * (group.first + group.last), std::max(kThinnest, 0.5 * group.extent())});
  }
  return sights;
}

void DynamicObstacles::update(const LaserScan2& scan, const Pose2& T_map_base, const planning::ClearanceMap& map) {
  follow(sightsIn(scan, T_map_base, map), scan.stamp);
}

/// Each sight continues the nearest track that no other one has continued, or begins one.
void DynamicObstacles::follow(const std::vector<Sight>& sights, Time now) {
  std::vector<Track> continued;
  for (const Sight& sight : sights) {
    Track* nearest = nullptr;
    double least = kSameTrack;
    for (Track& track : tracks_) {
      if (track.empty()) continue;
      const double seconds = toSeconds(sight.at - track.back().at);
      const double away = (track.back().centre + seconds * velocityOf(track) - sight.centre).norm();
      if (seconds > 0.0 && away < least) {
        least = away;
        nearest = &track;
      }
    }
    continued.push_back(nearest != nullptr ? std::exchange(*nearest, {}) : Track{});
    continued.back().push_back(sight);
    if (continued.size() >= kMostTracks) break;
  }
  for (Track& track : tracks_) {
    const double silent = track.empty() ? kLost : toSeconds(now - track.back().at);
    if (silent >= 0.0 && silent < kLost && continued.size() < kMostTracks) continued.push_back(std::move(track));
  }
  for (Track& track : continued) {
    const Time end = track.back().at;
    track.erase(track.begin(), std::find_if(track.begin(), track.end(), [&](const Sight& sight) {
                  return toSeconds(end - sight.at) <= kLookBack;
                }));
  }
  tracks_ = std::move(continued);
}

/// The slope of the line of least squares through the places over time; zero if there are too few.
Vec2 DynamicObstacles::velocityOf(const Track& track) {
  if (track.size() < 3 || toSeconds(track.back().at - track.front().at) < kShortestTrack) return Vec2::Zero();
  double mean_time = 0.0;
  Vec2 mean = Vec2::Zero();
  for (const Sight& sight : track) {
    mean_time += toSeconds(sight.at - track.front().at) / static_cast<double>(track.size());
    mean += sight.centre / static_cast<double>(track.size());
  }
  double times = 0.0;
  Vec2 both = Vec2::Zero();
  for (const Sight& sight : track) {
    const double t = toSeconds(sight.at - track.front().at) - mean_time;
    times += t * t;
    both += t * (sight.centre - mean);
  }
  const Vec2 velocity = both / times;
  return velocity.norm() > kFastestThing ? Vec2::Zero() : velocity;
}

std::vector<MovingDisc> DynamicObstacles::at(Time now) const {
  std::vector<MovingDisc> things;
  for (const Track& track : tracks_) {
    const double age = toSeconds(now - track.back().at);
    const Vec2 measured = velocityOf(track);
    const Vec2 velocity = measured.norm() < kSlowestThing ? Vec2(Vec2::Zero()) : measured;
    if (age < 0.0 || age > kOldest) continue;
    things.push_back({track.back().centre + age * velocity, velocity, track.back().radius});
  }
  return things;
}

}  // namespace frontier_pilot::navigation
