#include "frontier_pilot/mapping/surface_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace frontier_pilot {
namespace {

constexpr double kSteepest = 15.0;  ///< beams whose returns lie this many beam spacings apart may be on one surface
constexpr double kSlack = 0.05;     ///< and this much more, for noise [m]
constexpr int kMostMissing = 3;     ///< beams without a return between two that may be on one surface
constexpr double kElongated = 4.0;  ///< a line is this many times longer than it is thick
constexpr double kSameWay = 0.9;    ///< cosine of the greatest angle between normals of one surface
constexpr double kFlat = 0.25;      ///< greatest slope between two points of one surface

/// First and last of some successive points.
struct Span {
  std::size_t first, last;
  std::size_t size() const { return last - first + 1; }
};

struct Line {
  Vec2 normal;      ///< unit, either way round
  double variance;  ///< of the points from it [m^2]
};

/// Sums of the moments of the first n points, so that any span's line costs the same.
class LineFitter {
 public:
  explicit LineFitter(const SurfacePoints& points) {
    sums_.push_back({});
    for (const SurfacePoint& point : points) {
      const double x = point.position.x();
      const double y = point.position.y();
      const Sums& s = sums_.back();
      sums_.push_back({s[0] + x, s[1] + y, s[2] + x * x, s[3] + x * y, s[4] + y * y});
    }
  }

  /// The line through a span; none if its points are none.
  std::optional<Line> line(const Span& span, double max_error) const {
    if (span.size() < 3) return std::nullopt;
    const auto n = static_cast<double>(span.size());
    Sums mean{};
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] = (sums_[span.last + 1][k] - sums_[span.first][k]) / n;
    const double xx = mean[2] - mean[0] * mean[0];
    const double xy = mean[3] - mean[0] * mean[1];
    const double yy = mean[4] - mean[1] * mean[1];
    const double half = std::hypot(0.5 * (xx - yy), xy);
    const double across = std::max(0.0, 0.5 * (xx + yy) - half);
    const double along = 0.5 * (xx + yy) + half;
    if (across > max_error * max_error || along < kElongated * kElongated * across) return std::nullopt;
    return Line{direction(0.5 * std::atan2(2.0 * xy, xx - yy) + 0.5 * kPi), across * n / (n - 2.0)};
  }

 private:
  using Sums = std::array<double, 5>;
  std::vector<Sums> sums_;
};

/// Reads the returns beam by beam, and sees where the surface surely breaks off between them.
class ReturnReader {
 public:
  explicit ReturnReader(const LaserScan2& scan) : scan_(scan) {}

  SurfacePoints read() {
    for (std::size_t beam = 0; beam < scan_.ranges.size(); ++beam) {
      const RangeReading reading = readBeam(scan_, beam);
      if (reading.kind == RangeKind::kHit) add(beam, reading.distance);
      // A beam that says nothing may have met the same surface; one that met nothing has not.
      if (reading.kind == RangeKind::kFree) open_ = true;
    }
    return std::move(points_);
  }

 private:
  void add(std::size_t beam, double distance) {
    const Vec2 point = scan_.T_base_sensor * Vec2(distance * direction(scan_.angle(beam)));
    const auto apart = static_cast<double>(beam - last_beam_);
    const double spacing = apart * std::abs(scan_.angle_increment) * std::min(distance, last_distance_);
    const bool connected = !open_ && beam - last_beam_ <= kMostMissing + 1 &&
                           (point - points_.back().position).norm() <= kSteepest * spacing + kSlack;
    points_.push_back({point, Vec2::Zero(), connected});
    last_beam_ = beam;
    last_distance_ = distance;
    open_ = false;
  }

  const LaserScan2& scan_;
  SurfacePoints points_;
  std::size_t last_beam_ = 0;
  double last_distance_ = 0.0;
  bool open_ = true;  ///< nothing connects the next return to the last one
};

/// The connected points around `i` within `radius`, but at least two on each side.
Span around(const SurfacePoints& points, std::size_t i, double radius) {
  const auto belongs = [&](std::size_t j, std::size_t count) {
    return count < 2 || (points[j].position - points[i].position).squaredNorm() <= radius * radius;
  };
  Span span{i, i};
  while (points[span.first].connected && belongs(span.first - 1, i - span.first)) --span.first;
  while (span.last + 1 < points.size() && points[span.last + 1].connected && belongs(span.last + 1, span.last - i)) {
    ++span.last;
  }
  return span;
}

/// The normal at `i` by the neighbours on both sides; on one side only where that fits much better: next to a corner.
/// A side must not win by being asked first, or all corners would turn the same way, and the robot's yaw drift.
Vec2 normalAt(const LineFitter& fitter, const Span& span, std::size_t i, double max_error) {
  constexpr double kMuchBetter = 0.5;
  std::optional<Line> best = fitter.line(span, max_error);
  double least = best ? kMuchBetter * best->variance : std::numeric_limits<double>::infinity();
  for (const Span& side : {Span{span.first, i}, Span{i, span.last}}) {
    const auto line = fitter.line(side, max_error);
    if (!line || line->variance >= least) continue;
    least = line->variance;
    best = line;
  }
  return best ? best->normal : Vec2(0.0, 0.0);
}

/// Successive points that look the same way, to be replaced by their mean.
class Group {
 public:
  explicit Group(const SurfacePoint& first) : first_(first) { add(first); }
  bool takes(const SurfacePoint& point, double spacing) const {
    if (point.hasNormal() != first_.hasNormal()) return false;
    const bool same_way = !point.hasNormal() || point.normal.dot(first_.normal) > kSameWay;
    return same_way && (point.position - first_.position).squaredNorm() < spacing * spacing;
  }
  void add(const SurfacePoint& point) {
    position_ += point.position;
    normal_ += point.normal;
    ++count_;
  }
  SurfacePoint mean() const {
    return {position_ / count_, first_.hasNormal() ? Vec2(normal_.normalized()) : Vec2(0.0, 0.0)};
  }

 private:
  SurfacePoint first_;
  Vec2 position_ = Vec2::Zero();
  Vec2 normal_ = Vec2::Zero();
  int count_ = 0;
};

SurfacePoints groupMeans(const SurfacePoints& points, double spacing) {
  SurfacePoints result;
  std::optional<Group> group;
  for (const SurfacePoint& point : points) {
    if (group && group->takes(point, spacing)) {
      group->add(point);
      continue;
    }
    if (group) result.push_back(group->mean());
    group.emplace(point);
  }
  if (group) result.push_back(group->mean());
  return result;
}

/// Evenly spread, in their order.
SurfacePoints everyNth(const SurfacePoints& points, std::size_t n) {
  SurfacePoints result;
  for (std::size_t i = 0; i < points.size(); i += n) result.push_back(points[i]);
  return result;
}

/// Whether the surface goes on from `a` to `b`, the point after it.
bool onOneSurface(const SurfacePoint& a, const SurfacePoint& b, double max_gap) {
  const Vec2 step = b.position - a.position;
  const double gap = step.norm();
  if (!b.connected || !a.hasNormal() || !b.hasNormal() || gap > max_gap) return false;
  const double slope = std::max(std::abs(step.dot(a.normal)), std::abs(step.dot(b.normal)));
  return a.normal.dot(b.normal) > kSameWay && slope <= kFlat * gap;
}

}  // namespace

SurfacePoints readSurface(const LaserScan2& scan, const SurfaceParameters& parameters) {
  SurfacePoints points = ReturnReader(scan).read();
  const LineFitter fitter(points);
  const Vec2 sensor = scan.T_base_sensor.position();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 normal = normalAt(fitter, around(points, i, parameters.fit_radius), i, parameters.fit_error);
    points[i].normal = normal.dot(sensor - points[i].position) < 0.0 ? Vec2(-normal) : normal;
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
    for (int k = 1; k < pieces; ++k) result.push_back({points[i].position + step * k / pieces, normal});
  }
  return result;
}

SurfacePoints surfaceOf(const OccupancyGrid& map) {
  constexpr std::array<Cell, 4> kSides = {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}};
  SurfacePoints result;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (!isOccupied(map[i])) continue;
    const Cell cell = map.geometry().cell(i);
    for (const Cell& side : kSides) {
      if (!isFree(map.get({cell.x + side.x, cell.y + side.y}, kUnknown))) continue;
      const Vec2 normal(side.x, side.y);
      result.push_back({map.geometry().centre(cell) + 0.5 * map.resolution() * normal, normal});
    }
  }
  return result;
}

}  // namespace frontier_pilot
