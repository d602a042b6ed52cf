#pragma once

#include <cstddef>
#include <vector>

namespace frontier_pilot::exploration {

/// The costs of a tour that begins at a fixed place and visits every stop once, in any order, without a way back.
struct TourCosts {
  std::vector<double> first;  ///< from the beginning to each stop
  std::vector<double> legs;   ///< from stop i to stop j at [i * size() + j]
  std::vector<double> last;   ///< for ending at each stop, for example the way home

  explicit TourCosts(std::size_t stops) : first(stops, 0.0), legs(stops * stops, 0.0), last(stops, 0.0) {}
  std::size_t size() const { return first.size(); }
  double leg(std::size_t from, std::size_t to) const { return legs[from * size() + to]; }
  double& leg(std::size_t from, std::size_t to) { return legs[from * size() + to]; }
};

/// The stops in the order of a tour.
using Tour = std::vector<std::size_t>;

double costOf(const Tour& tour, const TourCosts& costs);

/// The open travelling salesman's tour. Costs need not be symmetric. Up to 9 stops: the best tour, by dynamic
/// programming (Held & Karp, J. SIAM 10(1), 1962; Bellman, J. ACM 9(1), 1962). More: cheapest insertion, then moves of
/// up to three successive stops (Or, PhD thesis, Northwestern University, 1976) and reversals (Croes, Operations
/// Research 6(6), 1958) while they shorten the tour. Deterministic.
Tour solveOpenTour(const TourCosts& costs);

/// The same with the tour's first stop given. `first` < costs.size().
Tour solveOpenTour(const TourCosts& costs, std::size_t first);

}  // namespace frontier_pilot::exploration
