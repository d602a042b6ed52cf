#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iomanip>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "frontier_pilot/core/grid_traversal.h"
#include "frontier_pilot/localization/map_localization.h"
#include "frontier_pilot/scan_matching/correlative_search.h"
#include "frontier_pilot/scan_matching/surface_map.h"

namespace frontier_pilot::localization {
namespace {

constexpr double kMinScore = 0.45;                  // least mean likelihood of the points
constexpr double kMinInliers = 0.8;                 // least share of the beams that end on surfaces
constexpr double kMinInliersOfLast = 0.7;           // the same of the last of several scans
constexpr double kMostContradicted = 0.1;           // greatest share of beams that pass through walls
constexpr double kMostContradictedUnrefined = 0.4;  // before the pose is refined
constexpr double kAlike = 0.9;            // a place with this share of the best one's score and inliers is a rival
constexpr int kCoarser = 2;               // times the side of the map's cells is that of the searched ones
constexpr double kPeakDistance = 0.5;     // [m]: poses nearer than this to a place belong to it
constexpr double kPeakAngle = 0.3;        // [rad]
constexpr std::size_t kMostBeams = 160;   // whose contradictions are looked at
constexpr double kSpacing = 0.2;          // [m] between the points that are matched
constexpr std::size_t kFewPoints = 100;   // fewer are matched with half that spacing
constexpr double kLeastOfHighest = 0.85;  // share of the highest score that a place needs

/// 1 in the coarse cells that hold a free cell of `map`.
Grid<std::uint8_t> freeCells(const OccupancyGrid& map) {
  GridGeometry coarse = map.geometry();
  coarse.resolution *= kCoarser;
  coarse.width = (coarse.width + kCoarser - 1) / kCoarser;
  coarse.height = (coarse.height + kCoarser - 1) / kCoarser;
  Grid<std::uint8_t> free(coarse);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Cell cell = map.geometry().cell(i);
    if (isFree(map[i])) free[Cell{cell.x / kCoarser, cell.y / kCoarser}] = 1;
  }
  return free;
}

/// The means of the points in the cells of a grid with sides of `side` [m], whichever scan they come from, in the frame
/// of the last scan.
surfaces::SurfacePoints merged(const std::vector<RecentScan>& scans, double side) {
  std::map<std::pair<int, int>, std::pair<surfaces::SurfacePoint, int>> cells;
  for (const RecentScan& scan : scans) {
    for (const surfaces::SurfacePoint& point : surfaces::placed(scan.T_last_base, scan.points)) {
      const std::pair<int, int> cell(static_cast<int>(std::floor(point.position.x() / side)),
                                     static_cast<int>(std::floor(point.position.y() / side)));
      const auto [entry, is_new] = cells.try_emplace(cell, point, 1);
      if (is_new) continue;
      auto& [mean, count] = entry->second;
      ++count;
      mean.position += (point.position - mean.position) / count;
    }
  }
  surfaces::SurfacePoints points;
  for (const auto& [cell, mean] : cells) points.push_back(mean.first);
  return points;
}

scan_matching::LikelihoodParameters coarser(const scan_matching::LikelihoodParameters& fine, double resolution) {
  return {kCoarser * resolution, kCoarser * fine.sigma};
}

/// Every n-th of `points`, so that there are no more than `most`.
surfaces::SurfacePoints withAtMost(std::size_t most, const surfaces::SurfacePoints& points) {
  const std::size_t step = (points.size() + most - 1) / std::max<std::size_t>(1, most);
  surfaces::SurfacePoints some;
  for (std::size_t i = 0; i < points.size(); i += std::max<std::size_t>(1, step)) some.push_back(points[i]);
  return some;
}

class Search {
 public:
  Search(const OccupancyGrid& grid, const slam::LocalSlamParameters& parameters, const std::function<bool()>& stop)
      : grid_(grid), parameters_(parameters), map_(parameters.likelihood) {
    const surfaces::SurfacePoints surface = surfaces::surfaceOf(grid);
    map_.add(surface, Pose2());
    if (map_.empty()) return;
    const Grid<std::uint8_t> coarse =
        scan_matching::likelihoodField(surface, coarser(parameters.likelihood, grid.resolution()));
    const GridGeometry& geometry = coarse.geometry();
    const Vec2 half = 0.5 * geometry.resolution * Vec2(geometry.width, geometry.height);
    whole_.expected = Pose2(geometry.origin + half, 0.0);
    whole_.window = {half.x(), half.y(), kPi};
    whole_.min_score = kMinScore;
    whole_.stop = stop;
    const int top = scan_matching::pyramidTop(whole_.window, geometry.resolution);
    pyramid_.emplace(coarse, top);
    free_.emplace(freeCells(grid), top);
  }

  WholeMapSearch by(const std::vector<RecentScan>& scans) const {
    WholeMapSearch result = toTheEnd(scans);
    // What a stopped search has not found may be there all the same.
    if (pyramid_ && whole_.stop && whole_.stop()) result.verdict = SearchVerdict::kStopped;
    return result;
  }

  /// Whether enough of the beams of a scan end on surfaces of the map if it was taken at this pose.
  bool fits(const RecentScan& scan, const Pose2& T_map_base) const {
    return onSurfaces({RecentScan{scan.points, Pose2()}}, T_map_base) >= kMinInliersOfLast;
  }

 private:
  WholeMapSearch toTheEnd(std::vector<RecentScan> scans) const {
    WholeMapSearch result;
    if (!pyramid_) return result;
    surfaces::SurfacePoints points = merged(scans, kSpacing);
    if (points.size() < kFewPoints) points = merged(scans, 0.5 * kSpacing);
    result.verdict = SearchVerdict::kTooFew;
    if (points.size() < static_cast<std::size_t>(parameters_.tracker.min_points)) return result;
    for (RecentScan& scan : scans) scan.points = withAtMost(kMostBeams / scans.size(), scan.points);
    result.verdict = SearchVerdict::kFitsNowhere;
    scan_matching::SearchRequest request = whole_;
    request.allowed = &*free_;
    // What scores best may be contradicted by the map; the robot's place does not score much less.
    const auto highest = scan_matching::correlativeSearch(*pyramid_, points, request);
    if (!highest) return result;
    request.min_score = std::max(kMinScore, kLeastOfHighest * highest->score);
    Places places;
    const auto placeNear = [&](const Pose2& pose) -> const std::optional<Place>& {
      const auto [entry, is_new] = places.try_emplace(zoneOf(pose));
      if (is_new) entry->second = placeAt(pose, points, scans);
      return entry->second;
    };
    request.accept = [&](const Pose2& pose) { return placeNear(pose).has_value(); };
    const auto best = scan_matching::correlativeSearch(*pyramid_, points, request);
    if (!best) return result;
    result.best = *placeNear(best->pose);
    request.exclusions = {{best->pose, kPeakDistance, kPeakAngle}};
    request.min_score = kAlike * best->score;
    request.accept = [&](const Pose2& pose) {
      const std::optional<Place>& place = placeNear(pose);
      return place && place->inliers >= kAlike * result.best.inliers;
    };
    const auto rival = scan_matching::correlativeSearch(*pyramid_, points, request);
    result.verdict = rival ? SearchVerdict::kAmbiguous : SearchVerdict::kFound;
    if (rival) result.rival = *placeNear(rival->pose);
    return result;
  }

  /// Poses so near to each other that they lead to the same place: many score alike, and checking one takes a while.
  using Zone = std::array<int, 3>;
  using Places = std::map<Zone, std::optional<Place>>;
  static Zone zoneOf(const Pose2& pose) {
    constexpr double kSide = 0.15;  // [m]
    constexpr double kTurn = 0.06;  // [rad]
    return {static_cast<int>(std::floor(pose.x / kSide)), static_cast<int>(std::floor(pose.y / kSide)),
            static_cast<int>(std::floor(pose.yaw / kTurn))};
  }

  /// The place near `start`, unless too few beams end on surfaces there, or too many pass through walls.
  std::optional<Place> placeAt(const Pose2& start, const surfaces::SurfacePoints& points,
                               const std::vector<RecentScan>& scans) const {
    if (contradicted(scans, start) > kMostContradictedUnrefined) return std::nullopt;
    const scan_matching::Refinement refined =
        scan_matching::refine(map_, points, start, std::nullopt, parameters_.tracker.refinement);
    const Place place{refined.pose, onSurfaces(scans, refined.pose)};
    const bool fits = place.inliers >= kMinInliers && contradicted(scans, refined.pose) <= kMostContradicted;
    return fits ? std::optional<Place>(place) : std::nullopt;
  }

  /// Share of the beams that end within about 10 cm of a surface of the map.
  double onSurfaces(const std::vector<RecentScan>& scans, const Pose2& T_map_last) const {
    constexpr std::uint8_t kNear = 60;
    const Grid<std::uint8_t>& field = map_.field();
    return share(scans, T_map_last,
                 [&](const Vec2&, const Vec2& to) { return field.get(field.geometry().cellAt(to), 0) >= kNear; });
  }

  /// Share of the beams that pass through walls of the map.
  double contradicted(const std::vector<RecentScan>& scans, const Pose2& T_map_last) const {
    return share(scans, T_map_last, [&](const Vec2& from, const Vec2& to) { return isBlocked(from, to); });
  }

  /// Share of the beams for which `is(from, to)` is true, in the map frame; `to` is where the beam was reflected.
  template <class Predicate>
  static double share(const std::vector<RecentScan>& scans, const Pose2& T_map_last, Predicate is) {
    double count = 0.0;
    double beams = 0.0;
    for (const RecentScan& scan : scans) {
      const Pose2 T_map_base = T_map_last * scan.T_last_base;
      for (const surfaces::SurfacePoint& point : scan.points) {
        beams += 1.0;
        if (is(T_map_base.position(), T_map_base * point.position)) count += 1.0;
      }
    }
    return count / std::max(1.0, beams);
  }

  /// Whether a wall lies between `from` and `to`. A beam that grazes a wall is not blocked by it: it may pass a cell
  /// beside.
  bool isBlocked(const Vec2& from, const Vec2& to) const {
    constexpr double kBefore = 0.3;  // [m]: what is so near to the point may be what it lies on
    const double range = (to - from).norm();
    if (range <= kBefore) return false;
    const Vec2 along = (to - from) / range;
    const Vec2 aside = grid_.resolution() * Vec2(-along.y(), along.x());
    return std::all_of(kLanes.begin(), kLanes.end(), [&](double lane) {
      const Vec2 begin = from + lane * aside;
      return !visitCells(grid_.geometry(), begin, begin + (range - kBefore) * along,
                         [&](Cell cell) { return !isOccupied(grid_.get(cell, kUnknown)); });
    });
  }

  static constexpr std::array<double, 3> kLanes = {0.0, 1.0, -1.0};  // beside the beam [cells]
  const OccupancyGrid& grid_;
  const slam::LocalSlamParameters& parameters_;
  scan_matching::SurfaceMap map_;
  scan_matching::SearchRequest whole_;
  std::optional<scan_matching::MaxPyramid> pyramid_;  ///< of a coarse field; none without a surface in the map
  std::optional<scan_matching::MaxPyramid> free_;     ///< where the robot may be
};

std::string toText(const Place& place) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << place.T_map_base.x << ", " << place.T_map_base.y << ", "
       << std::setprecision(0) << place.T_map_base.yaw * 180.0 / kPi << " deg (" << 100.0 * place.inliers
       << " % of its beams end on the map)";
  return text.str();
}

}  // namespace

WholeMapSearch searchWholeMap(const OccupancyGrid& map, const std::vector<RecentScan>& scans,
                              const slam::GraphSlamParameters& parameters, const std::function<bool()>& stop) {
  const Search search(map, parameters.local, stop);
  const WholeMapSearch result = search.by(scans);
  if (scans.size() < 2) return result;
  // If odometry was wrong, the scans do not fit each other; if the robot was carried, the last one does not fit where
  // the others do. It still may fit the map alone.
  const bool has_place = result.verdict == SearchVerdict::kFound || result.verdict == SearchVerdict::kAmbiguous;
  const bool holds =
      has_place ? search.fits(scans.back(), result.best.T_map_base) : result.verdict != SearchVerdict::kFitsNowhere;
  return holds ? result : search.by({RecentScan{scans.back().points, Pose2()}});
}

std::string describe(const WholeMapSearch& search) {
  switch (search.verdict) {
    case SearchVerdict::kFound:
      return "found the robot at " + toText(search.best);
    case SearchVerdict::kNoMap:
      return "refused: there is no map to look on";
    case SearchVerdict::kTooLarge:
      return "refused: the map is too large to be searched, see docs/limits.md";
    case SearchVerdict::kTooFew:
      return "refused: there is no scan yet, or it has too few returns";
    case SearchVerdict::kFitsNowhere:
      return "refused: the scan fits nowhere on the map";
    case SearchVerdict::kStopped:
      return "refused: the search took too long, drive on and call again, or give a pose";
    case SearchVerdict::kAmbiguous:
      break;
  }
  return "refused: two places look alike, " + toText(search.best) + " and " + toText(search.rival) +
         "; drive to where they differ, or give a pose";
}

}  // namespace frontier_pilot::localization
