#include "fleet/path_conflict.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace frontier_pilot::fleet {
namespace {

constexpr double kSpacing = 0.1;        // [m]
constexpr double kMostGap = 1.0;        // [m]: a wider place within a narrow stretch that is too short to pass in
constexpr double kSameDirection = 0.5;  // cosine

/// Where a line comes nearest to a point.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  double along = 0.0;
  Vec2 heading = Vec2::Zero();  ///< of the line there; zero for a single point
};

Nearest nearestOn(const std::vector<Vec2>& line, const Vec2& point) {
  Nearest best{(line.front() - point).norm(), 0.0, Vec2::Zero()};
  double along = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 step = line[i + 1] - line[i];
    const double length = step.norm();
    if (length < 1e-6) continue;
    const double part = std::clamp(step.dot(point - line[i]) / (length * length), 0.0, 1.0);
    const double distance = (line[i] + part * step - point).norm();
    if (distance < best.distance || i == 0) best = {distance, along + part * length, step / length};
    along += length;
  }
  return best;
}

/// How far it is free from `from` along `unit`, at most `most` [m].
double freeAlong(const OccupancyGrid& map, const Vec2& from, const Vec2& unit, double most) {
  const double step = 0.5 * map.resolution();
  for (double s = 0.0; s < most; s += step) {
    if (isOccupied(map.get(map.geometry().cellAt(from + s * unit), kUnknown))) return s;
  }
  return most;
}

/// The width of the passage at `point` for a robot that drives along `heading`, at most `most` [m]; oblique sections
/// are wider than the passage, so the narrowest of three counts.
double widthAt(const OccupancyGrid& map, const Vec2& point, const Vec2& heading, double most) {
  double width = most;
  for (const double turn : {-0.5, 0.0, 0.5}) {
    const Vec2 side = direction(bearing(heading) + 0.5 * kPi + turn);
    width = std::min(width, freeAlong(map, point, side, most) + freeAlong(map, point, -side, most));
  }
  return width;
}

/// Where `line`, which is narrow at `from`, becomes wide for longer than a gap [m along it].
double exitBehind(const std::vector<Vec2>& line, double from, const PassingRoom& room, const OccupancyGrid& map) {
  const std::vector<Vec2> samples = resampled(line, kSpacing, kConflictReach);
  double exit = from;
  double s = 0.0;
  for (std::size_t i = 0; i + 1 < samples.size() && s <= exit + kMostGap; ++i) {
    const Vec2 step = samples[i + 1] - samples[i];
    if (s > exit && !step.isZero() && widthAt(map, samples[i], step, room.width) < room.width) exit = s;
    s += step.norm();
  }
  return exit;
}

/// The stretch that findConflict looks for, while it grows.
struct Stretch {
  bool found = false;
  double first = 0.0, last = 0.0;  ///< along the own way
  double other_exit = 0.0;
  double agreement = 0.0;  ///< sum of the cosines between both directions
  int samples = 0;

  void add(double s, const Vec2& heading, const Nearest& there) {
    if (!found) first = s;
    found = true;
    last = s;
    other_exit = std::max(other_exit, there.along);
    agreement += heading.dot(there.heading);
    ++samples;
  }
};

}  // namespace

std::vector<Vec2> remaining(const std::vector<Vec2>& line, const Vec2& position) {
  std::vector<Vec2> rest{position};
  const double from = line.empty() ? 0.0 : nearestOn(line, position).along;
  double along = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    along += (line[i] - line[i - 1]).norm();
    if (along > from) rest.push_back(line[i]);
  }
  return rest;
}

double distanceTo(const std::vector<Vec2>& line, const Vec2& point) { return nearestOn(line, point).distance; }

std::vector<Vec2> resampled(const std::vector<Vec2>& line, double spacing, double reach) {
  std::vector<Vec2> points;
  double left = reach;
  for (std::size_t i = 0; i + 1 < line.size() && left > 0.0; ++i) {
    const double length = (line[i + 1] - line[i]).norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / spacing)));
    for (int k = 0; k < pieces && left > 0.0; ++k, left -= length / pieces)
      points.emplace_back(line[i] + (static_cast<double>(k) / pieces) * (line[i + 1] - line[i]));
  }
  if (!line.empty() && left > 0.0) points.push_back(line.back());
  return points;
}

std::optional<PathConflict> findConflict(const std::vector<Vec2>& own, const std::vector<Vec2>& other,
                                         const PassingRoom& room, const OccupancyGrid& map) {
  if (own.size() < 2 || other.empty()) return std::nullopt;
  const std::vector<Vec2> samples = resampled(own, kSpacing, kConflictReach);
  Stretch stretch;
  double s = 0.0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const Vec2 step = samples[i + 1] - samples[i];
    const Nearest there = nearestOn(other, samples[i]);
    const bool shared = there.distance < room.apart && !step.isZero();
    if (shared && widthAt(map, samples[i], step, room.width) < room.width) stretch.add(s, step.normalized(), there);
    if (stretch.found && s - stretch.last > kMostGap) break;
    s += step.norm();
  }
  if (!stretch.found || stretch.agreement > kSameDirection * stretch.samples) return std::nullopt;
  return PathConflict{stretch.first, exitBehind(own, stretch.last, room, map),
                      exitBehind(other, stretch.other_exit, room, map)};
}

}  // namespace frontier_pilot::fleet
