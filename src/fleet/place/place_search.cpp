#include "fleet/place/place_search.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "fleet/place/map_windows.h"
#include "fleet/place/wall_faces.h"
#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/scan_matching/correlative_search.h"
#include "frontier_pilot/scan_matching/surface_map.h"
#include "frontier_pilot/surfaces/surface_points.h"

namespace frontier_pilot::fleet {
namespace {

using surfaces::SurfacePoints;

constexpr double kCoarse = 0.1;             // side of the cells that are searched [m]
constexpr double kFine = 0.05;              // side of those on which walls are compared [m]
constexpr std::size_t kFewPoints = 30;      // a window with fewer says too little
constexpr double kMinScore = 0.45;          // least mean likelihood of a window's points
constexpr double kRival = 0.85;             // share of the best place's score from which another one is looked at
constexpr double kAsGood = 0.7;             // share of the best place's support from which another one is as good
constexpr double kPeakDistance = 0.6;       // places nearer than that and kPeakAngle are the same [m]
constexpr double kPeakAngle = 0.3;          // [rad]
constexpr double kLeastOverlap = 15.0;      // [m^2]
constexpr std::size_t kLeastKnown = 150;    // points of walls in the overlap, 5 cm apart
constexpr double kLeastSupported = 0.92;    // share of them on walls of the other map: 0.97 at true places
constexpr double kMostContradicted = 0.03;  // share of walls in the other map's free space: 0.01 at true places
constexpr std::size_t kLeastWalls = 200;    // cells of walls without which that says nothing
constexpr std::size_t kSparse = 8;          // of so many points of the walls, one is looked at first
constexpr double kLeastSparse = 0.8;        // share of those that must lie on walls before all are looked at
constexpr double kNearWalls = 0.2;          // standard deviation of the likelihood of their surroundings [m]
constexpr double kLeastPromising = 0.8;     // share of the walls that must lie there before a place is refined
constexpr double kBehind = 0.1;             // a wall's face [m]
constexpr std::uint8_t kOnWall = 60;        // likelihood within 1.7 standard deviations of a wall
constexpr double kSettleStep = 0.1;         // between places along the walls that are compared [m]
constexpr int kSettleSteps = 10;            // of them in either direction
constexpr double kSettled = 0.3;  // error along the walls that is corrected later, when more of them is known [m]
constexpr double kClearlyBetter = 0.01;  // share of the walls by which the best of them has to be

SurfacePoints everyNth(const SurfacePoints& all, std::size_t n) {
  SurfacePoints some;
  for (std::size_t i = 0; i < all.size(); i += n) some.push_back(all[i]);
  return some;
}

/// Whether `match` does not make `best` doubtful: it is the same place, to which the refinement has led from elsewhere,
/// or far less of the walls speaks for it.
bool isNoRivalOf(const PlaceMatch& best, const PlaceMatch& match) {
  return areNear(best.T_a_b, match.T_a_b, kPeakDistance, kPeakAngle) ||
         static_cast<double>(match.supported) < kAsGood * static_cast<double>(best.supported);
}

scan_matching::SearchRequest anywhereOn(const GridGeometry& geometry) {
  const Vec2 half = 0.5 * geometry.resolution * Vec2(geometry.width, geometry.height);
  scan_matching::SearchRequest request;
  request.expected = Pose2(geometry.origin + half, 0.0);
  request.window = {half.x(), half.y(), kPi};
  request.min_score = kMinScore;
  return request;
}

/// The block around the occupied cells.
CellRect wallsOf(const OccupancyGrid& map) {
  CellRect walls;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      if (isOccupied(map.row(y)[x])) walls.include(Cell{x, y});
    }
  }
  return walls;
}

bool isNear(const Grid<std::uint8_t>& walls, const Vec2& point) {
  return walls.get(walls.geometry().cellAt(point), 0) >= kOnWall;
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

bool areNear(const Pose2& one, const Pose2& other, double distance, double angle) {
  return (other.position() - one.position()).norm() < distance && std::abs(angleDifference(other.yaw, one.yaw)) < angle;
}

bool canBeSearched(const OccupancyGrid& map) {
  const double most = static_cast<double>(bounds::kMostMapCells) * square(kFine / map.resolution());
  const auto fits = [&](const CellRect& cells) { return static_cast<double>(cells.width) * cells.height <= most; };
  return (fits(map.geometry().rect()) || fits(wallsOf(map))) &&
         surfaces::surfaceSize(map) <= bounds::kMostSurfacePoints;
}

struct PlaceSearch::Impl {
  Impl(const OccupancyGrid& map_a, const OccupancyGrid& map_b, const std::function<bool()>& stop_search)
      : a(map_a),
        b(map_b),
        stop(stop_search),
        surface_a(surfaces::surfaceOf(a)),
        surface(surfaces::surfaceOf(b)),
        sparse(everyNth(surface, kSparse)),
        faces(surface_a),
        walls(scan_matching::likelihoodField(surface_a, {kFine, 1.2 * kFine})),
        surroundings(scan_matching::likelihoodField(surface_a, {kCoarse, kNearWalls})) {}

  bool isStopped() const { return stop && stop(); }
  bool isOnWall(const Vec2& point) const { return isNear(walls, point); }
  bool knows(const Vec2& point) const { return !isUnknown(a.get(a.geometry().cellAt(point), kUnknown)); }

  /// How many of `points` (of b) lie where `a` knows the place, and how many of these on a wall, or near one.
  struct Support {
    std::size_t known = 0, walls = 0;
    double share() const { return static_cast<double>(walls) / static_cast<double>(std::max<std::size_t>(known, 1)); }
  };
  Support supportOf(const SurfacePoints& points, const Pose2& T_a_b, const Grid<std::uint8_t>& likelihood) const {
    Support support;
    const Rotation2 rotation(T_a_b.yaw);
    for (const surfaces::SurfacePoint& point : points) {
      const Vec2 there = rotation.applied(point.position, T_a_b.position());
      const Vec2 behind = there - kBehind * rotation.applied(point.normal, Vec2::Zero());
      const bool on_wall = isNear(likelihood, there);
      if (on_wall || (knows(there) && knows(behind))) ++support.known;
      if (on_wall) ++support.walls;
    }
    return support;
  }

  /// Whether the walls of b may become those of a when `T_a_b` is refined: few of them lie far from any.
  bool isPromising(const Pose2& T_a_b) const {
    return supportOf(sparse, T_a_b, surroundings).share() >= kLeastPromising;
  }

  /// The match near `T_a_b`, if there is one.
  std::optional<PlaceMatch> matchNear(const Pose2& T_a_b) const {
    const Pose2 guess = faces.climb(sparse, T_a_b);
    if (supportOf(sparse, guess, walls).share() < kLeastSparse) return std::nullopt;
    PlaceMatch match{faces.climb(surface, guess), {}, 0};
    const Support support = supportOf(surface, match.T_a_b, walls);
    if (support.known < kLeastKnown || support.share() < kLeastSupported) return std::nullopt;
    match.supported = support.walls;
    match.agreement = compare(a, b, match.T_a_b);
    const bool agrees = match.agreement.overlap >= kLeastOverlap && match.agreement.walls >= kLeastWalls &&
                        match.agreement.contradictedShare() <= kMostContradicted;
    return agrees ? std::optional<PlaceMatch>(match) : std::nullopt;
  }

  /// The share of the walls that speaks against a place: those of b without a wall of a, where a knows the place, and
  /// those in free space.
  double flawOf(const Pose2& T_a_b) const {
    return 1.0 - supportOf(surface, T_a_b, walls).share() + compare(a, b, T_a_b).contradictedShare();
  }

  /// The direction in which the walls that both maps know say least of where a place is, such as along a corridor.
  Vec2 weakDirection(const Pose2& T_a_b) const {
    Eigen::Matrix2d facing = Eigen::Matrix2d::Zero();
    const Rotation2 rotation(T_a_b.yaw);
    for (const surfaces::SurfacePoint& point : sparse) {
      if (!isOnWall(rotation.applied(point.position, T_a_b.position()))) continue;
      const Vec2 normal = rotation.applied(point.normal, Vec2::Zero());
      facing += normal * normal.transpose();
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(facing).eigenvectors().col(0);
  }

  /// The best of the matches along the walls from `match`. The refinement does not move from one door post to the next.
  /// Nothing if two of them are almost alike.
  std::optional<PlaceMatch> settled(const PlaceMatch& match) const {
    const Vec2 along = weakDirection(match.T_a_b);
    std::vector<std::pair<double, Pose2>> places{{flawOf(match.T_a_b), match.T_a_b}};
    for (int i = -kSettleSteps; i <= kSettleSteps && !isStopped(); ++i) {
      const Vec2 shifted = match.T_a_b.position() + i * kSettleStep * along;
      const Pose2 there = faces.climb(sparse, {shifted, match.T_a_b.yaw});
      const auto is_there = [&](const auto& place) { return areNear(place.second, there, kSettleStep, 0.02); };
      if (std::none_of(places.begin(), places.end(), is_there)) places.emplace_back(flawOf(there), there);
    }
    std::sort(places.begin(), places.end(), [](const auto& one, const auto& other) { return one.first < other.first; });
    const auto is_as_good = [&](const auto& place) {
      return place.first < places.front().first + kClearlyBetter &&
             !areNear(place.second, places.front().second, kSettled, kPi);
    };
    if (std::any_of(places.begin(), places.end(), is_as_good)) return std::nullopt;
    return places.front().second == match.T_a_b ? match : matchNear(places.front().second);
  }

  /// The only place on `whole`, which is `a`, at which the window fits.
  std::optional<PlaceMatch> placeOf(const MapWindow& window, const WholeMap& whole) const {
    const SurfacePoints points = window.pointsOf(surface);
    if (points.size() < kFewPoints) return std::nullopt;
    const Pose2 T_centre_b(-window.centre, 0.0);
    scan_matching::SearchRequest request = whole.anywhere;
    std::optional<PlaceMatch> best, accepted;
    // Several poses around a peak may be asked for: one that has been refused tells of its neighbours, too.
    std::vector<Pose2> refused;
    request.stop = stop;
    request.accept = [&](const Pose2& pose) {
      const auto is_near = [&](const Pose2& other) { return areNear(other, pose, 0.3, 0.1); };
      if (std::any_of(refused.begin(), refused.end(), is_near)) return false;
      const Pose2 place = pose * T_centre_b;
      const auto match = isPromising(place) ? matchNear(place) : std::nullopt;
      const bool is_other = match && !(best && isNoRivalOf(*best, *match));
      if (is_other) accepted = match;
      if (!is_other) refused.push_back(pose);
      return is_other;
    };
    const auto found = scan_matching::correlativeSearch(whole.pyramid, points, request);
    if (!found) return std::nullopt;
    best = accepted;  // what is accepted last is what was found
    request.exclusions = {{found->pose, kPeakDistance, kPeakAngle}};
    request.min_score = kRival * found->score;
    refused.clear();
    const bool ambiguous = scan_matching::correlativeSearch(whole.pyramid, points, request).has_value();
    return ambiguous || isStopped() ? std::nullopt : settled(*best);
  }

  const OccupancyGrid& a;
  const OccupancyGrid& b;
  std::function<bool()> stop;
  SurfacePoints surface_a;
  SurfacePoints surface;            ///< of b
  SurfacePoints sparse;             ///< of that, every kSparse-th point
  WallFaces faces;                  ///< of a
  Grid<std::uint8_t> walls;         ///< of a: their likelihood
  Grid<std::uint8_t> surroundings;  ///< of these walls
};

PlaceSearch::PlaceSearch(const OccupancyGrid& a, const OccupancyGrid& b, const std::function<bool()>& stop)
    : impl_(std::make_unique<Impl>(a, b, stop)) {}
PlaceSearch::~PlaceSearch() = default;

std::vector<PlaceMatch> PlaceSearch::search(WindowRound& round) const {
  std::vector<PlaceMatch> matches;
  if (impl_->surface_a.empty()) return matches;
  const WholeMap whole(impl_->surface_a);
  const auto is_known = [this](const Vec2& point) { return impl_->knows(point); };
  for (const MapWindow& window : round.next(windowsOf(impl_->surface), is_known)) {
    if (impl_->isStopped()) break;
    if (auto match = impl_->placeOf(window, whole)) matches.push_back(*match);
  }
  return matches;
}

std::optional<PlaceMatch> PlaceSearch::refine(const Pose2& T_a_b) const {
  const auto match = impl_->surface_a.empty() ? std::nullopt : impl_->matchNear(T_a_b);
  return match ? impl_->settled(*match) : std::nullopt;
}

}  // namespace frontier_pilot::fleet
