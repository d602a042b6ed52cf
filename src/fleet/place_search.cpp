#include "fleet/place_search.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "frontier_pilot/scan_matching/correlative_search.h"
#include "frontier_pilot/scan_matching/surface_map.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::fleet {
namespace {

using surfaces::SurfacePoints;

constexpr double kCoarse = 0.1;             // side of the cells that are searched [m]
constexpr double kFine = 0.05;              // side of those on which a place is refined [m]
constexpr double kCapture = 0.08;           // standard deviation of the likelihood there [m]
constexpr double kWindowSpacing = 2.5;      // between the centres of windows [m]
constexpr double kWindowRadius = 5.0;       // [m]
constexpr double kPointSpacing = 0.2;       // between the points that are searched for [m]
constexpr std::size_t kFewPoints = 50;      // a window with fewer says too little
constexpr double kMinScore = 0.5;           // least mean likelihood of a window's points
constexpr double kRival = 0.85;             // share of the best place's score from which another one is looked at
constexpr double kAsGood = 0.7;             // share of the best place's support from which another one is as good
constexpr double kPeakDistance = 0.6;       // places nearer than that and kPeakAngle are the same [m]
constexpr double kPeakAngle = 0.3;          // [rad]
constexpr double kLeastOverlap = 15.0;      // [m^2]
constexpr std::size_t kLeastKnown = 150;    // points of walls in the overlap, 5 cm apart
constexpr double kLeastSupported = 0.92;    // share of them on walls of the other map: 0.97 at true places
constexpr double kMostContradicted = 0.03;  // share of walls in the other map's free space: 0.01 at true places
constexpr std::size_t kLeastWalls = 200;    // cells of walls without which that says nothing
constexpr std::uint8_t kOnWall = 60;        // likelihood within about 10 cm of a wall
constexpr int kSteps = 15;                  // of the refinement

/// The points of `all` within kWindowRadius of `centre`, thinned, and in a frame at `centre`.
SurfacePoints windowAround(const Vec2& centre, const SurfacePoints& all) {
  std::map<std::pair<int, int>, surfaces::SurfacePoint> cells;
  for (const surfaces::SurfacePoint& point : all) {
    const Vec2 from = point.position - centre;
    if (from.squaredNorm() > square(kWindowRadius)) continue;
    surfaces::SurfacePoint moved = point;
    moved.position = from;
    const std::pair<int, int> cell(static_cast<int>(std::floor(from.x() / kPointSpacing)),
                                   static_cast<int>(std::floor(from.y() / kPointSpacing)));
    cells.try_emplace(cell, moved);
  }
  SurfacePoints points;
  for (const auto& [cell, point] : cells) points.push_back(point);
  return points;
}

/// Centres of windows that cover the walls of a map, in a fixed order.
std::vector<Vec2> windowCentres(const SurfacePoints& surface) {
  std::map<std::pair<int, int>, std::pair<Vec2, int>> cells;
  for (const surfaces::SurfacePoint& point : surface) {
    const std::pair<int, int> cell(static_cast<int>(std::floor(point.position.x() / kWindowSpacing)),
                                   static_cast<int>(std::floor(point.position.y() / kWindowSpacing)));
    auto& [sum, count] = cells.try_emplace(cell, Vec2::Zero(), 0).first->second;
    sum += point.position;
    ++count;
  }
  std::vector<Vec2> centres;
  for (const auto& [cell, sum] : cells) centres.emplace_back(sum.first / sum.second);
  return centres;
}

/// A likelihood between its cells' centres, 0 ... 1, and its gradient [1/m]: bilinear.
struct Sample {
  double value = 0.0;
  Vec2 gradient = Vec2::Zero();
};

Sample sample(const Grid<std::uint8_t>& field, const Vec2& point) {
  const GridGeometry& geometry = field.geometry();
  const Vec2 at = (point - geometry.origin) / geometry.resolution - Vec2(0.5, 0.5);
  const Cell low{static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
  const Vec2 part = at - Vec2(low.x, low.y);
  const auto value = [&](int dx, int dy) {
    return static_cast<double>(field.get({low.x + dx, low.y + dy}, 0)) / 255.0;
  };
  const std::array<double, 4> corner{value(0, 0), value(1, 0), value(0, 1), value(1, 1)};
  const double below = corner[0] + part.x() * (corner[1] - corner[0]);
  const double above = corner[2] + part.x() * (corner[3] - corner[2]);
  const double slope = (1.0 - part.y()) * (corner[1] - corner[0]) + part.y() * (corner[3] - corner[2]);
  return {below + part.y() * (above - below), Vec2(slope, above - below) / geometry.resolution};
}

/// The walls of a map by the direction that they face, so that the two sides of a thin wall, which two robots may have
/// seen from different rooms, are not taken for each other.
class Faces {
 public:
  explicit Faces(const SurfacePoints& surface) {
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
      SurfacePoints facing;
      for (const surfaces::SurfacePoint& point : surface) {
        if (point.normal.dot(kAxes[i]) > 0.5) facing.push_back(point);
      }
      fields_[i] = scan_matching::likelihoodField(facing, {kFine, kCapture});
    }
  }

  /// Moves `T_a_b` to where `points` (of b) lie on walls that face the same way: Gauss-Newton on 1 - likelihood, as in
  /// Kohlbrecher et al., "A Flexible and Scalable SLAM System with Full 3D Motion Estimation", SSRR 2011, here weighted
  /// by the likelihood, because many points of one map have no counterpart in the other.
  Pose2 climb(const SurfacePoints& points, Pose2 T_a_b) const {
    for (int step = 0; step < kSteps; ++step) {
      Eigen::Matrix3d hessian = 1e-6 * Eigen::Matrix3d::Identity();
      Eigen::Vector3d slope = Eigen::Vector3d::Zero();
      const Rotation2 rotation(T_a_b.yaw);
      for (const surfaces::SurfacePoint& point : points) {
        const Vec2 there = rotation.applied(point.position, T_a_b.position());
        const Vec2 normal = rotation.applied(point.normal, Vec2::Zero());
        for (std::size_t i = 0; i < kAxes.size(); ++i) {
          const double facing = normal.dot(kAxes[i]);
          if (facing > 0.2) add(fields_[i], there, there - T_a_b.position(), square(facing), hessian, slope);
        }
      }
      const Eigen::Vector3d change = hessian.ldlt().solve(slope);
      if (!change.allFinite() || change.norm() > 1.0) break;
      T_a_b = Pose2(T_a_b.x + change.x(), T_a_b.y + change.y(), T_a_b.yaw + change.z());
      if (change.head<2>().norm() < 1e-4 && std::abs(change.z()) < 1e-5) break;
    }
    return T_a_b;
  }

 private:
  static void add(const Grid<std::uint8_t>& field, const Vec2& there, const Vec2& arm, double facing,
                  Eigen::Matrix3d& hessian, Eigen::Vector3d& slope) {
    const Sample here = sample(field, there);
    if (here.value <= 0.0) return;
    const Eigen::Vector3d jacobian(here.gradient.x(), here.gradient.y(),
                                   arm.x() * here.gradient.y() - arm.y() * here.gradient.x());
    const double weight = facing * here.value;
    hessian += weight * jacobian * jacobian.transpose();
    slope += weight * (1.0 - here.value) * jacobian;
  }

  static inline const std::array<Vec2, 4> kAxes = {Vec2(1.0, 0.0), Vec2(-1.0, 0.0), Vec2(0.0, 1.0), Vec2(0.0, -1.0)};
  std::array<Grid<std::uint8_t>, 4> fields_;
};

scan_matching::SearchRequest anywhereOn(const GridGeometry& geometry) {
  const Vec2 half = 0.5 * geometry.resolution * Vec2(geometry.width, geometry.height);
  scan_matching::SearchRequest request;
  request.expected = Pose2(geometry.origin + half, 0.0);
  request.window = {half.x(), half.y(), kPi};
  request.min_score = kMinScore;
  return request;
}

/// A map on which windows are searched for: all over it, and in any direction.
struct WholeMap {
  explicit WholeMap(const SurfacePoints& surface)
      : WholeMap(scan_matching::likelihoodField(surface, {kCoarse, 1.2 * kCoarse})) {}
  explicit WholeMap(const Grid<std::uint8_t>& field)
      : anywhere(anywhereOn(field.geometry())),
        pyramid(field, scan_matching::pyramidTop(anywhere.window, field.geometry().resolution)) {}

  scan_matching::SearchRequest anywhere;
  scan_matching::MaxPyramid pyramid;
};

}  // namespace

struct PlaceSearch::Impl {
  Impl(const OccupancyGrid& map_a, const OccupancyGrid& map_b)
      : a(map_a),
        b(map_b),
        surface_a(surfaces::surfaceOf(a)),
        surface(surfaces::surfaceOf(b)),
        faces(surface_a),
        walls(scan_matching::likelihoodField(surface_a, {kFine, 1.2 * kFine})) {}

  /// The match near `T_a_b`, if there is one.
  std::optional<PlaceMatch> matchNear(const Pose2& T_a_b) const {
    PlaceMatch match{faces.climb(surface, T_a_b), {}, 0};
    std::size_t known = 0;
    for (const surfaces::SurfacePoint& point : surface) {
      const Vec2 there = match.T_a_b * point.position;
      const bool on_wall = walls.get(walls.geometry().cellAt(there), 0) >= kOnWall;
      if (on_wall || !isUnknown(a.get(a.geometry().cellAt(there), kUnknown))) ++known;
      if (on_wall) ++match.supported;
    }
    if (known < kLeastKnown || static_cast<double>(match.supported) < kLeastSupported * static_cast<double>(known)) {
      return std::nullopt;
    }
    match.agreement = compare(a, b, match.T_a_b);
    const bool agrees = match.agreement.overlap >= kLeastOverlap && match.agreement.walls >= kLeastWalls &&
                        match.agreement.contradictedShare() <= kMostContradicted;
    return agrees ? std::optional<PlaceMatch>(match) : std::nullopt;
  }

  /// The only place on `whole`, which is `a`, at which the window around `centre` fits.
  std::optional<PlaceMatch> placeOf(const Vec2& centre, const WholeMap& whole) const {
    const SurfacePoints points = windowAround(centre, surface);
    if (points.size() < kFewPoints) return std::nullopt;
    const Pose2 T_centre_b(-centre, 0.0);
    scan_matching::SearchRequest request = whole.anywhere;
    std::optional<PlaceMatch> best, accepted;
    // Several poses around a peak may be asked for: one that has been refused tells of its neighbours, too.
    std::vector<Pose2> refused;
    request.accept = [&](const Pose2& pose) {
      const auto near = [&](const Pose2& other) {
        return (other.position() - pose.position()).norm() < 0.3 &&
               std::abs(angleDifference(other.yaw, pose.yaw)) < 0.1;
      };
      if (std::any_of(refused.begin(), refused.end(), near)) return false;
      const auto match = matchNear(pose * T_centre_b);
      if (!match || (best && static_cast<double>(match->supported) < kAsGood * static_cast<double>(best->supported))) {
        refused.push_back(pose);
        return false;
      }
      accepted = match;
      return true;
    };
    const auto found = scan_matching::correlativeSearch(whole.pyramid, points, request);
    if (!found) return std::nullopt;
    best = accepted;  // what is accepted last is what was found
    request.exclusions = {{found->pose, kPeakDistance, kPeakAngle}};
    request.min_score = kRival * found->score;
    refused.clear();
    const bool ambiguous = scan_matching::correlativeSearch(whole.pyramid, points, request).has_value();
    return ambiguous ? std::nullopt : best;
  }

  const OccupancyGrid& a;
  const OccupancyGrid& b;
  SurfacePoints surface_a;
  SurfacePoints surface;     ///< of b
  Faces faces;               ///< of a
  Grid<std::uint8_t> walls;  ///< of a: their likelihood
};

PlaceSearch::PlaceSearch(const OccupancyGrid& a, const OccupancyGrid& b) : impl_(std::make_unique<Impl>(a, b)) {}
PlaceSearch::~PlaceSearch() = default;

std::vector<PlaceMatch> PlaceSearch::search(std::size_t first, std::size_t most) const {
  std::vector<PlaceMatch> matches;
  if (impl_->surface_a.empty()) return matches;
  const WholeMap whole(impl_->surface_a);
  const std::vector<Vec2> centres = windowCentres(impl_->surface);
  for (std::size_t i = 0; i < std::min(most, centres.size()); ++i) {
    if (auto match = impl_->placeOf(centres[(first + i) % centres.size()], whole)) matches.push_back(*match);
  }
  return matches;
}

std::optional<PlaceMatch> PlaceSearch::refine(const Pose2& T_a_b) const {
  return impl_->surface_a.empty() ? std::nullopt : impl_->matchNear(T_a_b);
}

}  // namespace frontier_pilot::fleet
