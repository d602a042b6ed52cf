#include "navigation/dynamic_obstacles.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace frontier_pilot::navigation {
namespace {

constexpr std::size_t kMostBeams = 720;
constexpr std::size_t kMostThings = 50;
constexpr std::size_t kFewestHits = 3;  ///< of a thing
constexpr double kNear = 4.0;           ///< farther things are not tracked [m]
constexpr double kOffWalls = 0.15;      ///< least distance of a thing from what the map shows [m]
constexpr double kBesideWalls = 0.05;   ///< hits that are farther from it may be on a part of a thing [m]
constexpr double kPart = 0.3;           ///< greatest distance of such a hit from an end of the thing [m]
constexpr double kSameThing = 0.15;     ///< between neighbouring hits of one thing [m]
constexpr double kMissed = 0.2;         ///< between them, where beams had no hit on it [rad]
constexpr double kWidest = 1.2;         ///< a group that is wider is no thing that drives or walks [m]
constexpr double kThinnest = 0.1;       ///< least radius that a thing is given, as its far side is not seen [m]
constexpr double kSameTrack = 0.35;     ///< between where a thing is expected and where it is seen [m]
constexpr double kSameTime = 0.05;      ///< by which a sight may be older than the one before it, across a seam [s]
constexpr double kLookBack = 0.8;       ///< velocities are those of this time [s]
constexpr double kShortestTrack = 0.3;  ///< that gives a velocity [s]
constexpr double kLost = 0.6;           ///< a thing that was not seen for longer is another one [s]
constexpr double kOldest = 1.0;         ///< what was last seen before that is nowhere any more [s]
constexpr double kSlowestThing = 0.12;  ///< of a thing that counts as moving [m/s]
constexpr double kSameWay = 1.2;        ///< by which its ends may differ, as a share of the velocity of its middle
constexpr double kFastestThing = 2.0;   ///< faster ones are different things that were taken for one [m/s]

/// When a beam of a scan that was placed was measured: the stamp is the time of the last one.
Time timeOf(const LaserScan2& scan, double beam) {
  if (!scan.isMoving()) return scan.stamp;
  const double left = scan.reversed ? beam : static_cast<double>(scan.ranges.size()) - 1.0 - beam;
  return scan.stamp - fromSeconds(left * scan.time_increment);
}

}  // namespace

/// Neighbouring hits where the map knows the floor to be free.
struct DynamicObstacles::Group {
  Sight sight;
  std::size_t first_beam = 0, last_beam = 0;
  std::size_t hits = 0;
  double distance = 0.0;  ///< of the nearest hit from the robot [m]

  double extent() const { return (sight.last - sight.first).norm(); }

  void add(const Vec2& point, std::size_t beam, const Vec2& robot) {
    const double away = (point - robot).norm();
    if (hits == 0 || away < distance) {
      distance = away;
      sight.nearest = point;
    }
    sight.last = point;
    last_beam = beam;
    ++hits;
  }

  /// The rest of the same thing, beyond the last beam of the scan. The halves were measured a sweep apart: the time is
  /// that of the larger one.
  void append(const Group& rest) {
    if (rest.hits > hits) sight.at = rest.sight.at;
    if (rest.distance < distance) {
      distance = rest.distance;
      sight.nearest = rest.sight.nearest;
    }
    sight.last = rest.sight.last;
    hits += rest.hits;
  }
};

struct DynamicObstacles::Hits {
  std::vector<Group> groups;
  std::vector<Vec2> beside_walls;  ///< they may be on a thing or on the wall
};

DynamicObstacles::Hits DynamicObstacles::hitsIn(const LaserScan2& scan, const Pose2& T_map_base,
                                                const planning::ClearanceMap& map) {
  const auto cells = [&](double distance) { return static_cast<int>(std::ceil(distance / map.geometry().resolution)); };
  const int off_walls = cells(kOffWalls), beside_walls = cells(kBesideWalls);
  Hits hits;
  std::vector<Group>& groups = hits.groups;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const RangeReading reading = readBeam(scan, beam);
    if (reading.kind != RangeKind::kHit || reading.distance > kNear) continue;
    const Vec2 point = T_map_base * scan.point(beam, reading.distance);
    const Cell cell = map.geometry().cellAt(point);
    if (!map.isFreeFloor(cell, off_walls)) {
      if (map.isFreeFloor(cell, beside_walls)) hits.beside_walls.push_back(point);
      continue;
    }
    const auto continues = [&](const Group& group) {
      const double missed = static_cast<double>(beam - group.last_beam) * std::abs(scan.angle_increment);
      return missed < kMissed && (group.sight.last - point).norm() < kSameThing;
    };
    if (groups.empty() || !continues(groups.back())) {
      groups.emplace_back();
      groups.back().sight.first = point;
      groups.back().first_beam = beam;
    }
    groups.back().add(point, beam, T_map_base.position());
  }
  for (Group& group : groups)
    group.sight.at = timeOf(scan, 0.5 * static_cast<double>(group.first_beam + group.last_beam));
  if (groups.size() > 1 && (groups.back().sight.last - groups.front().sight.first).norm() < kSameThing) {
    groups.back().append(groups.front());
    groups.erase(groups.begin());
  }
  return hits;
}

std::vector<DynamicObstacles::Sight> DynamicObstacles::thingsAmong(Hits hits, const Vec2& robot) {
  std::vector<Group>& groups = hits.groups;
  std::sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.distance < b.distance; });
  std::vector<Sight> sights;
  for (const Group& group : groups) {
    const bool is_thing = group.hits >= kFewestHits && group.extent() <= kWidest;
    if (is_thing && sights.size() < kMostThings) sights.push_back(group.sight);
  }
  for (Sight& sight : sights) {
    for (const Vec2& point : hits.beside_walls) {
      const bool is_part = std::min((point - sight.first).norm(), (point - sight.last).norm()) < kPart;
      if (is_part && (point - robot).norm() < (sight.nearest - robot).norm()) sight.nearest = point;
    }
  }
  return sights;
}

void DynamicObstacles::update(const LaserScan2& scan, const Pose2& T_map_base, const planning::ClearanceMap& map) {
  if (map.empty()) return;
  follow(thingsAmong(hitsIn(withAtMost(kMostBeams, scan), T_map_base, map), T_map_base.position()), scan.stamp);
}

/// Continues each track with the sight that is nearest to where the thing is expected, the nearest pairs first. What is
/// left of the sights begins tracks.
void DynamicObstacles::follow(const std::vector<Sight>& sights, Time now) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const Sight& before = tracks_[i].back();
    const Vec2 velocity = velocityOf(tracks_[i]);
    for (std::size_t k = 0; k < sights.size(); ++k) {
      const double seconds = toSeconds(sights[k].at - before.at);
      const Vec2 moved = 0.5 * (sights[k].first + sights[k].last - before.first - before.last);
      const double away = (moved - seconds * velocity).norm();
      if (seconds > -kSameTime && away < kSameTrack) pairs.emplace_back(away, i, k);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<bool> continued(tracks_.size()), used(sights.size());
  for (const auto& [away, i, k] : pairs) {
    if (continued[i] || used[k]) continue;
    continued[i] = used[k] = true;
    if (sights[k].at <= tracks_[i].back().at) tracks_[i].pop_back();
    tracks_[i].push_back(sights[k]);
  }
  for (std::size_t k = 0; k < sights.size(); ++k) {
    if (!used[k]) tracks_.push_back({sights[k]});
  }
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(),
                               [&](const Track& track) { return std::abs(toSeconds(now - track.back().at)) > kLost; }),
                tracks_.end());
  for (Track& track : tracks_) {
    const auto is_recent = [&](const Sight& sight) { return toSeconds(track.back().at - sight.at) <= kLookBack; };
    track.erase(track.begin(), std::find_if(track.begin(), track.end(), is_recent));
  }
}

/// The slope of the line of least squares through a place of the thing over time.
Vec2 DynamicObstacles::slope(const Track& track, Vec2 Sight::*place) {
  const auto count = static_cast<double>(track.size());
  double mean_time = 0.0;
  Vec2 mean = Vec2::Zero();
  for (const Sight& sight : track) {
    mean_time += toSeconds(sight.at - track.front().at) / count;
    mean += sight.*place / count;
  }
  double times = 0.0;
  Vec2 both = Vec2::Zero();
  for (const Sight& sight : track) {
    const double t = toSeconds(sight.at - track.front().at) - mean_time;
    times += t * t;
    both += t * (sight.*place - mean);
  }
  return both / times;
}

/// The velocity of its middle, if both ends move in that way: when another side of a box comes into view only one end
/// does. Zero if they do not, or if the track is too short.
Vec2 DynamicObstacles::velocityOf(const Track& track) {
  if (track.size() < 3 || toSeconds(track.back().at - track.front().at) < kShortestTrack) return Vec2::Zero();
  const Vec2 first = slope(track, &Sight::first);
  const Vec2 last = slope(track, &Sight::last);
  const Vec2 velocity = 0.5 * (first + last);
  const bool both = (first - last).norm() < kSameWay * velocity.norm();
  const bool moves = both && velocity.norm() >= kSlowestThing && velocity.norm() <= kFastestThing;
  return moves ? velocity : Vec2::Zero();
}

std::vector<SeenThing> DynamicObstacles::at(Time now) const {
  std::vector<SeenThing> things;
  for (const Track& track : tracks_) {
    const Sight& sight = track.back();
    const double age = std::max(0.0, toSeconds(now - sight.at));  // a stamp may be a little ahead of the clock
    if (age > kOldest) continue;
    const Vec2 velocity = velocityOf(track);
    const double radius = std::max(kThinnest, 0.5 * (sight.last - sight.first).norm());
    const Vec2 moved = age * velocity;
    things.push_back({{0.5 * (sight.first + sight.last) + moved, velocity, radius}, sight.nearest + moved});
  }
  return things;
}

}  // namespace frontier_pilot::navigation
