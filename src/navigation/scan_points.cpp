#include "navigation/scan_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace frontier_pilot::navigation {
namespace {

constexpr float kFarAway = 1e6F;
const Duration kExtrapolation = fromSeconds(0.2);

/// Near surfaces are averaged over this many beams to either side: because of noise the nearest of many readings is
/// much nearer than the surface, which would make narrow passages impassable.
constexpr long kAveraged = 3;
constexpr double kAveragedWithin = 1.0;  ///< hits farther away lie too far apart [m]
constexpr double kSameSurface = 0.04;    ///< neighbours that differ by more belong to another surface [m]

/// The distance of a hit, averaged with those of its neighbours that lie on the same surface.
double averaged(const LaserScan2& scan, std::size_t beam, double distance) {
  if (distance > kAveragedWithin) return distance;
  const auto beams = static_cast<long>(scan.ranges.size());
  double sum = 0.0;
  int count = 0;
  for (long offset = -kAveraged; offset <= kAveraged; ++offset) {
    const long other = static_cast<long>(beam) + offset;
    if (other < 0 || other >= beams) continue;
    const RangeReading reading = readBeam(scan, static_cast<std::size_t>(other));
    if (reading.kind != RangeKind::kHit || std::abs(reading.distance - distance) > kSameSurface) continue;
    sum += reading.distance;
    ++count;
  }
  return sum / count;
}

/// The beam whose angle is nearest to the bearing of `seen` in the scanner's frame; it may lie outside of the scan.
long beamTowards(const LaserScan2& scan, const Vec2& seen) {
  const double turns = std::remainder(bearing(seen) - scan.angle_min, 2.0 * kPi * (scan.angle_increment > 0 ? 1 : -1));
  const long beam = std::lround(turns / scan.angle_increment);
  return beam < 0 ? beam + std::lround(2.0 * kPi / std::abs(scan.angle_increment)) : beam;
}

/// Where `obstacle` was in the frame of a scanner that moved, when a beam pointed at it, and that beam; nothing if none
/// did. Where the scanner was depends on the beam, and the beam on where it was: a few rounds find both, because a
/// robot turns much more slowly than its scanner.
std::optional<std::pair<long, Vec2>> seenWhileMoving(const LaserScan2& scan, const Pose2& T_map_base,
                                                     const Vec2& obstacle) {
  constexpr int kRounds = 4;
  const Vec2 in_base = T_map_base.inverse() * obstacle;
  const auto beams = static_cast<long>(scan.ranges.size());
  long beam = beamTowards(scan, scan.T_base_sensor.inverse() * in_base);
  for (int round = 0; round < kRounds; ++round) {
    const Vec2 seen = scan.mount(static_cast<std::size_t>(std::clamp(beam, 0L, beams - 1))).inverse() * in_base;
    const long next = beamTowards(scan, seen);
    if (std::abs(next - beam) <= 1 && next < beams) return std::pair(next, seen);
    beam = next;
  }
  return std::nullopt;
}

}  // namespace

void ScanPoints::add(const Vec2& point) {
  x.push_back(static_cast<float>(point.x()));
  y.push_back(static_cast<float>(point.y()));
}

ScanPoints ScanPoints::near(const Vec2& centre, double radius) const {
  ScanPoints result;
  const auto cx = static_cast<float>(centre.x());
  const auto cy = static_cast<float>(centre.y());
  const auto limit = static_cast<float>(radius * radius);
  for (std::size_t i = 0; i < size(); ++i) {
    const float dx = x[i] - cx;
    const float dy = y[i] - cy;
    if (dx * dx + dy * dy > limit) continue;
    result.x.push_back(x[i]);
    result.y.push_back(y[i]);
  }
  while (result.size() % kLanes != 0) {
    result.x.push_back(kFarAway);
    result.y.push_back(kFarAway);
  }
  return result;
}

double ScanPoints::distance(const Vec2& point) const {
  const auto px = static_cast<float>(point.x());
  const auto py = static_cast<float>(point.y());
  // One minimum per lane: a single one would be a chain of comparisons that the compiler may not vectorise.
  std::array<float, kLanes> least{};
  least.fill(kFarAway * kFarAway);
  const std::size_t whole = size() / kLanes * kLanes;
  for (std::size_t i = 0; i < whole; i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const float dx = x[i + k] - px;
      const float dy = y[i + k] - py;
      const float squared = dx * dx + dy * dy;
      least[k] = squared < least[k] ? squared : least[k];
    }
  }
  for (std::size_t i = whole; i < size(); ++i) {
    const float squared = (x[i] - px) * (x[i] - px) + (y[i] - py) * (y[i] - py);
    least[0] = std::min(least[0], squared);
  }
  return std::sqrt(static_cast<double>(*std::min_element(least.begin(), least.end())));
}

double ScanPoints::distance(const Outline& outline, const Pose2& T_map_base) const {
  if (outline.isDisc()) return distance(T_map_base.position()) - outline.inscribedRadius();
  const Pose2 T_base_map = T_map_base.inverse();
  double least = static_cast<double>(kFarAway);
  for (std::size_t i = 0; i < size(); ++i) {
    const Vec2 point = T_base_map * Vec2(static_cast<double>(x[i]), static_cast<double>(y[i]));
    // The outline is at least as far away as the circle around it.
    if (point.norm() - outline.circumscribedRadius() < least) least = std::min(least, outline.distance(point));
  }
  return least;
}

ScanPoints scanPoints(const LaserScan2& scan, const Pose2& T_map_base, const Outline& outline) {
  const Pose2 T_map_mount = T_map_base * scan.T_base_sensor;
  ScanPoints points;
  points.x.reserve(scan.ranges.size());
  points.y.reserve(scan.ranges.size());
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    const RangeReading reading = readBeam(scan, i);
    if (reading.kind != RangeKind::kHit && reading.kind != RangeKind::kTooNear) continue;
    double distance = reading.kind == RangeKind::kHit ? averaged(scan, i, reading.distance) : reading.distance;
    if (reading.kind == RangeKind::kTooNear) {
      const Vec2 unit = direction(scan.T_base_sensor.yaw + scan.angle(i));
      distance = std::min(distance, outline.distanceToEdge(scan.T_base_sensor.position(), unit));
    }
    const Pose2 T_map_sensor = scan.isMoving() ? T_map_base * scan.mount(i) : T_map_mount;
    points.add(T_map_sensor.position() + distance * direction(T_map_sensor.yaw + scan.angle(i)));
  }
  return points;
}

std::optional<ScanView::Look> ScanView::lookAt(const Vec2& place) const {
  const auto beams = static_cast<long>(scan_.ranges.size());
  if (beams == 0) return std::nullopt;
  Vec2 seen = (T_map_base_ * scan_.T_base_sensor).inverse() * place;
  long beam = beamTowards(scan_, seen);
  if (scan_.isMoving()) {
    const auto found = seenWhileMoving(scan_, T_map_base_, place);
    if (!found) return std::nullopt;
    std::tie(beam, seen) = *found;
  }
  if (beam < 0 || beam >= beams) return std::nullopt;
  return Look{seen.norm(), static_cast<std::size_t>(std::max(0L, beam - 1)),
              static_cast<std::size_t>(std::min(beams - 1, beam + 1))};
}

bool ScanView::looksAt(const Vec2& place) const {
  const std::optional<Look> look = lookAt(place);
  if (!look) return false;
  for (std::size_t beam = look->first; beam <= look->last; ++beam) {
    if (readBeam(scan_, beam).kind != RangeKind::kInvalid) return true;
  }
  return false;
}

bool ScanView::seesThrough(const Vec2& place, double behind) const {
  const std::optional<Look> look = lookAt(place);
  if (!look) return false;
  for (std::size_t beam = look->first; beam <= look->last; ++beam) {
    const RangeReading reading = readBeam(scan_, beam);
    if (reading.kind == RangeKind::kInvalid || reading.distance < look->range + behind) return false;
  }
  return true;
}

bool isUsable(const LaserScan2& scan) {
  std::size_t valid = 0;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) valid += readBeam(scan, i).kind != RangeKind::kInvalid ? 1 : 0;
  return valid * 10 > scan.ranges.size() && looksAhead(scan);
}

void PoseHistory::add(Time stamp, const Pose2& T_map_base) {
  const bool known = !track_.empty();
  if (known && stamp == track_.poses().back().stamp) return track_.correct(T_map_base);
  if (!known || stamp > track_.poses().back().stamp) track_.add(stamp, T_map_base);
}

std::optional<Pose2> PoseHistory::at(Time stamp) const {
  constexpr Duration kAnyGap = Duration::max();
  return track_.away(stamp, kAnyGap) > kExtrapolation ? std::nullopt : track_.nearest(stamp);
}

}  // namespace frontier_pilot::navigation
