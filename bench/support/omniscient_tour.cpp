#include "support/omniscient_tour.h"

#include <algorithm>
#include <cmath>

#include "sim/reachable_floor.h"
#include "support/tour/path_shortening.h"
#include "support/tour/sight.h"
#include "support/tour/tour_search.h"
#include "support/tour/waypoint_graph.h"

namespace frontier_pilot::bench {
namespace {

constexpr double kSpacing = 0.4;      ///< of waypoints [m]
constexpr double kDenseArea = 300.0;  ///< on a greater floor there are as many waypoints as on this one [m^2]
constexpr double kMargin = 0.001;     ///< of the share, because the search reckons with larger cells
constexpr int kAttempts = 5;

double areaOf(const Grid<std::uint8_t>& floor) {
  const auto cells = std::count(floor.cells().begin(), floor.cells().end(), 1);
  return static_cast<double>(cells) * floor.resolution() * floor.resolution();
}

std::vector<Vec2> placesOf(const WaypointGraph& graph, const std::vector<int>& way) {
  std::vector<Vec2> places;
  for (const int node : way) places.push_back(graph.place(node));
  return places;
}

}  // namespace

OmniscientTour omniscientTour(const OccupancyGrid& truth, const Vec2& start, const TourTask& task) {
  const Terrain terrain(truth, start, task.radius);
  const int radius = static_cast<int>(std::ceil(task.radius / truth.resolution()));
  const Grid<std::uint8_t> floor = sim::reachableFloor(truth, truth.geometry().cellAt(start), radius);
  const double spacing = kSpacing * std::max(1.0, std::sqrt(areaOf(floor) / kDenseArea));
  const WaypointGraph graph(terrain, start, spacing);
  const Sight sight(truth, task.range);
  const FloorBits bits(floor);
  std::vector<View> views;
  for (int node = 0; node < graph.size(); ++node) views.push_back(bits.viewFrom(graph.place(node), sight));

  double share = task.share + kMargin;
  for (int attempt = 1;; ++attempt) {
    const int needed = static_cast<int>(std::ceil(std::min(1.0, share) * bits.count()));
    const std::vector<int> way = TourSearch(graph, views, bits, needed).run(task.rounds);
    SeeingPath path(terrain, floor, sight, placesOf(graph, way));
    share += task.share - path.seen() + kMargin;
    if (path.seen() < task.share && attempt < kAttempts) continue;
    path.shorten(task.share);
    return {path.corners(), path.length(), path.seen()};
  }
}

}  // namespace frontier_pilot::bench
