#include "frontier_pilot/surfaces/surface_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "surfaces/line_fitter.h"
#include "surfaces/lone_returns.h"
#include "surfaces/span_finder.h"

namespace frontier_pilot::surfaces {
namespace {

constexpr double kSteepest = 15.0;  ///< returns at most this many beam spacings apart may be on one surface
constexpr double kSlack = 0.05;     ///< tolerance added to that, for noise [m]
constexpr int kMostMissing = 3;     ///< invalid beams between two returns that may be on one surface
constexpr double kSameWay = 0.9;    ///< cosine of the greatest angle between normals of one surface
constexpr double kFlat = 0.25;      ///< greatest slope between two points of one surface

/// Reads a scan beam by beam, and finds between which returns the surface surely ends.
class BeamReader {
 public:
  explicit BeamReader(const LaserScan2& scan) : scan_(scan) {}

  SurfaceScan read() {
    for (std::size_t beam = 0; beam < scan_.ranges.size(); ++beam) {
      const RangeReading reading = readBeam(scan_, beam);
      if (reading.kind == RangeKind::kHit) add(beam, reading.distance);
      if (reading.kind == RangeKind::kTooNear) ++too_near_;
      // An invalid beam may have met the same surface; a beam without a return has not.
      if (reading.kind != RangeKind::kFree) continue;
      open_ = true;
      free_.push_back(scan_.angle(beam));
      if (scan_.isMoving()) free_mounts_.push_back(scan_.mount(beam));
    }
    return {scan_.stamp,     scan_.T_base_sensor,       std::move(points_),      std::move(free_),
            scan_.range_max, std::move(point_origins_), std::move(free_mounts_), loneReturns(scan_),
            too_near_};
  }

 private:
  void add(std::size_t beam, double distance) {
    const Vec2 point = scan_.point(beam, distance);
    const auto apart = static_cast<double>(beam - last_beam_);
    const double spacing = apart * std::abs(scan_.angle_increment) * std::min(distance, last_distance_);
    const bool connected = !open_ && beam - last_beam_ <= kMostMissing + 1 &&
                           (point - points_.back().position).norm() <= kSteepest * spacing + kSlack;
    points_.push_back({point, Vec2::Zero(), connected});
    if (scan_.isMoving()) point_origins_.push_back(scan_.mount(beam).position());
    last_beam_ = beam;
    last_distance_ = distance;
    open_ = false;
  }

  const LaserScan2& scan_;
  SurfacePoints points_;
  std::vector<double> free_;
  std::vector<Vec2> point_origins_;
  std::vector<Pose2> free_mounts_;
  std::size_t too_near_ = 0;
  std::size_t last_beam_ = 0;
  double last_distance_ = 0.0;
  bool open_ = true;  ///< the next return is not connected to the last one
};

/// Sine of the angle by which the surface bends at `i`, between the lines fitted to the span before it and after it;
/// zero where one of the two is missing.
double bendAt(const LineFitter& fitter, const Span& span, std::size_t i, double max_error) {
  const auto before = fitter.arm({span.first, i}, max_error);
  const auto after = fitter.arm({i, span.last}, max_error);
  if (!before || !after) return 0.0;
  return std::abs(before->normal.x() * after->normal.y() - before->normal.y() * after->normal.x());
}

/// Where two connected surfaces meet: at the sharpest bend nearby. A line fitted across a corner would have the normal
/// of neither wall.
std::vector<bool> cornersOf(const SurfacePoints& points, const SpanFinder& neighbours, const LineFitter& fitter,
                            const SurfaceParameters& parameters) {
  constexpr double kArm = 0.5;     // of `fit_radius`: length of the lines on either side
  constexpr double kApart = 0.25;  // of `fit_radius`: least distance between corners
  constexpr double kSharp = 0.5;   // sine of the least bend of a corner
  std::vector<double> values;
  values.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    values.push_back(bendAt(fitter, neighbours.around(i, kArm * parameters.fit_radius), i, parameters.fit_error));
  }
  const RangeMaximum bends(std::move(values));
  std::vector<bool> corners(points.size(), false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (bends[i] < kSharp) continue;
    corners[i] = bends[i] >= bends(neighbours.around(i, kApart * parameters.fit_radius));
  }
  return corners;
}

/// For each point the nearest corners before and after it; the first or the last point where there is none.
std::vector<Span> betweenCorners(const std::vector<bool>& corners) {
  std::vector<Span> between(corners.size(), {0, 0});
  for (std::size_t i = 1; i < corners.size(); ++i) between[i].first = corners[i - 1] ? i - 1 : between[i - 1].first;
  for (std::size_t i = corners.size(); i-- > 0;) {
    const bool is_last = i + 1 == corners.size();
    between[i].last = is_last || corners[i + 1] ? std::min(i + 1, corners.size() - 1) : between[i + 1].last;
  }
  return between;
}

/// The part of `span` between the nearest corners, including these.
Span overlapOf(const Span& span, const Span& between) {
  return {std::max(span.first, between.first), std::min(span.last, between.last)};
}

/// The cosine of the angle of incidence of a beam, bounded from below; one where there is no normal.
double facingOf(const SurfacePoint& point, const Vec2& beam) {
  constexpr double kFlattest = 0.05;
  const double range = beam.norm();
  return point.hasNormal() && range > 0.0 ? std::max(kFlattest, std::abs(beam.dot(point.normal)) / range) : 1.0;
}

/// The variance by range and bearing across the surface [m^2]; errors along it do not matter.
double noiseOf(double range, double facing, const SurfaceParameters& parameters) {
  return square(parameters.range_noise * facing) + square(parameters.bearing_noise * range) * (1.0 - square(facing));
}

/// Whether a point and the one after it may be replaced by their mean.
bool belongTogether(const SurfacePoint& a, const SurfacePoint& b, double spacing) {
  if (a.hasNormal() != b.hasNormal() || (b.position - a.position).squaredNorm() >= spacing * spacing) return false;
  return !a.hasNormal() || a.normal.dot(b.normal) > kSameWay;
}

SurfacePoint meanOf(const SurfacePoints& points, const Span& span) {
  SurfacePoint mean{Vec2::Zero(), Vec2::Zero(), false, 0.0, 0.0};
  for (std::size_t i = span.first; i <= span.last; ++i) {
    mean.position += points[i].position;
    mean.normal += points[i].normal;
    mean.noise += points[i].noise;
    mean.roughness += points[i].roughness;
  }
  const auto count = static_cast<double>(span.size());
  mean.position /= count;
  mean.normal.normalize();
  // Noise is independent from point to point, roughness is common to them.
  mean.noise /= square(count);
  mean.roughness /= count;
  return mean;
}

/// Adds the means of equal parts of `span` that are at most `spacing` [m] long.
void addMeans(const SurfacePoints& points, const Span& span, double spacing, SurfacePoints& means) {
  // Lengths along the surface: noise across it would lengthen the path from point to point.
  std::vector<double> along = {0.0};
  for (std::size_t i = span.first; i < span.last; ++i) {
    const Vec2 step = points[i + 1].position - points[i].position;
    const double across = step.dot((points[i].normal + points[i + 1].normal).normalized());
    along.push_back(along.back() + std::sqrt(std::max(0.0, step.squaredNorm() - across * across)));
  }
  const double parts = std::max(1.0, std::ceil(along.back() / spacing));
  const auto partOf = [&](std::size_t i) {
    return parts > 1.0 ? std::min(parts - 1.0, std::floor(along[i - span.first] / along.back() * parts)) : 0.0;
  };
  Span part{span.first, span.first};
  for (std::size_t i = span.first + 1; i <= span.last; ++i) {
    if (partOf(i) != partOf(part.first)) {
      means.push_back(meanOf(points, part));
      part.first = i;
    }
    part.last = i;
  }
  means.push_back(meanOf(points, part));
}

/// The means of groups of points. A stretch of wall is divided evenly: if each group began where the last one was full,
/// groups would depend on the direction in which the scanner turns, and on rough walls that would turn the robot.
SurfacePoints groupMeans(const SurfacePoints& points, double spacing) {
  SurfacePoints means;
  Span span{0, 0};
  for (std::size_t i = 0; i < points.size(); ++i) {
    span.last = i;
    if (i + 1 < points.size() && belongTogether(points[i], points[i + 1], spacing)) continue;
    addMeans(points, span, spacing, means);
    span.first = i + 1;
  }
  return means;
}

/// Every n-th point, in the same order.
SurfacePoints everyNth(const SurfacePoints& points, std::size_t n) {
  SurfacePoints result;
  for (std::size_t i = 0; i < points.size(); i += n) result.push_back(points[i]);
  return result;
}

/// Whether `a` and `b`, the point after it, lie on one surface.
bool onOneSurface(const SurfacePoint& a, const SurfacePoint& b, double max_gap) {
  const Vec2 step = b.position - a.position;
  const double gap = step.norm();
  if (!b.connected || !a.hasNormal() || !b.hasNormal() || gap > max_gap) return false;
  const double slope = std::max(std::abs(step.dot(a.normal)), std::abs(step.dot(b.normal)));
  return a.normal.dot(b.normal) > kSameWay && slope <= kFlat * gap;
}

/// Calls `visit` with each occupied cell and each of its sides behind which there is a free one.
template <class Visit>
void forEachBorder(const OccupancyGrid& map, const Visit& visit) {
  constexpr std::array<Cell, 4> kSides = {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}};
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!isOccupied(map[i])) continue;
    const Cell cell = map.geometry().cell(i);
    for (const Cell& side : kSides) {
      if (isFree(map.get({cell.x + side.x, cell.y + side.y}, kUnknown))) visit(cell, side);
    }
  }
}

}  // namespace

SurfaceScan readScan(const LaserScan2& scan, const SurfaceParameters& parameters) {
  SurfaceScan read = BeamReader(scan).read();
  SurfacePoints& points = read.points;
  const LineFitter fitter(points);
  const SpanFinder neighbours(points);
  const Vec2 sensor = scan.T_base_sensor.position();
  const std::vector<bool> corners = cornersOf(points, neighbours, fitter, parameters);
  const std::vector<Span> between = betweenCorners(corners);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Span span = overlapOf(neighbours.around(i, parameters.fit_radius), between[i]);
    // A corner is on both walls: which of them it is assigned to must not depend on the order of the beams.
    const auto line = corners[i] ? std::nullopt : fitter.line(span, parameters.fit_error);
    SurfacePoint& point = points[i];
    const Vec2 beam = point.position - (read.point_origins.empty() ? sensor : read.point_origins[i]);
    if (line) point.normal = line->normal.dot(beam) > 0.0 ? Vec2(-line->normal) : line->normal;
    const double facing = facingOf(point, beam);
    point.noise = noiseOf(beam.norm(), facing, parameters);
    point.roughness = square(parameters.roughness);
    if (line) point.roughness += std::max(0.0, line->variance - point.noise) / square(facing);
  }
  return read;
}

SurfacePoints placed(const Pose2& T_other_points, SurfacePoints points) {
  const Rotation2 rotation(T_other_points.yaw);
  for (SurfacePoint& point : points) {
    point.position = rotation.applied(point.position, T_other_points.position());
    point.normal = rotation * point.normal;
  }
  return points;
}

SurfacePoints thinned(const SurfacePoints& points, const SurfaceParameters& parameters) {
  constexpr double kWider = 1.3;
  constexpr double kWidest = 4.0;
  const auto most = static_cast<std::size_t>(parameters.max_points);
  double spacing = parameters.thinning;
  SurfacePoints result = groupMeans(points, spacing);
  while (result.size() > most && spacing < kWidest * parameters.thinning) {
    spacing *= kWider;
    result = groupMeans(points, spacing);
  }
  return result.size() > most ? everyNth(result, (result.size() + most - 1) / most) : result;
}

SurfacePoints filled(const SurfacePoints& points, const SurfaceParameters& parameters) {
  SurfacePoints result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.push_back(points[i]);
    if (i + 1 == points.size() || !onOneSurface(points[i], points[i + 1], parameters.max_gap)) continue;
    const Vec2 step = points[i + 1].position - points[i].position;
    const int pieces = static_cast<int>(std::ceil(step.norm() / parameters.fill_spacing));
    const Vec2 normal = (points[i].normal + points[i + 1].normal).normalized();
    // All points that fill a gap together weigh about as much as one point.
    const double noise = 0.5 * (points[i].noise + points[i + 1].noise) * pieces;
    const double roughness = 0.5 * (points[i].roughness + points[i + 1].roughness) * pieces;
    for (int k = 1; k < pieces; ++k) {
      result.push_back({points[i].position + step * k / pieces, normal, true, noise, roughness});
    }
  }
  return result;
}

std::size_t surfaceSize(const OccupancyGrid& map) {
  std::size_t count = 0;
  forEachBorder(map, [&](const Cell&, const Cell&) { ++count; });
  return count;
}

SurfacePoints surfaceOf(const OccupancyGrid& map) {
  SurfacePoints result;
  result.reserve(surfaceSize(map));
  forEachBorder(map, [&](const Cell& cell, const Cell& side) {
    const Vec2 normal(side.x, side.y);
    result.push_back({map.geometry().centre(cell) + 0.5 * map.resolution() * normal, normal});
  });
  return result;
}

}  // namespace frontier_pilot::surfaces
