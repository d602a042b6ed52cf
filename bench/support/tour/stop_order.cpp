#include "support/tour/stop_order.h"

#include <algorithm>

namespace frontier_pilot::bench {
namespace {

constexpr double kLeastGain = 1e-4;  // [m]
constexpr std::size_t kLongestRun = 3;

bool twoOpt(const WaypointGraph& graph, std::vector<int>& stops) {
  const std::size_t count = stops.size();
  for (std::size_t i = 1; i + 1 < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      double gain = graph.distance(stops[i - 1], stops[i]) - graph.distance(stops[i - 1], stops[j]);
      if (j + 1 < count) gain += graph.distance(stops[j], stops[j + 1]) - graph.distance(stops[i], stops[j + 1]);
      if (gain < kLeastGain) continue;
      std::reverse(stops.begin() + static_cast<std::ptrdiff_t>(i), stops.begin() + static_cast<std::ptrdiff_t>(j) + 1);
      return true;
    }
  }
  return false;
}

/// The length that is saved when the stops [from, from + run) are left out.
double saved(const WaypointGraph& graph, const std::vector<int>& stops, std::size_t from, std::size_t run) {
  const double in = graph.distance(stops[from - 1], stops[from]);
  if (from + run == stops.size()) return in;
  return in + graph.distance(stops[from + run - 1], stops[from + run]) -
         graph.distance(stops[from - 1], stops[from + run]);
}

/// The additional length of going from `first` to `last` before the stop `before` of `stops`, without their distance.
double insertionCost(const WaypointGraph& graph, const std::vector<int>& stops, std::size_t before, int first,
                     int last) {
  const double in = graph.distance(stops[before - 1], first);
  if (before == stops.size()) return in;
  return in + graph.distance(last, stops[before]) - graph.distance(stops[before - 1], stops[before]);
}

/// Moves the stops [from, from + run) elsewhere, in either direction.
bool moveRun(const WaypointGraph& graph, std::vector<int>& stops, std::size_t from, std::size_t run) {
  const double gain = saved(graph, stops, from, run);
  const auto begin = stops.begin() + static_cast<std::ptrdiff_t>(from);
  std::vector<int> moved(begin, begin + static_cast<std::ptrdiff_t>(run));
  std::vector<int> rest = stops;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(from), rest.begin() + static_cast<std::ptrdiff_t>(from + run));
  for (std::size_t before = 1; before <= rest.size(); ++before) {
    for (int turn = 0; turn < 2; ++turn, std::reverse(moved.begin(), moved.end())) {
      if (gain - insertionCost(graph, rest, before, moved.front(), moved.back()) < kLeastGain) continue;
      rest.insert(rest.begin() + static_cast<std::ptrdiff_t>(before), moved.begin(), moved.end());
      stops = std::move(rest);
      return true;
    }
  }
  return false;
}

bool orOpt(const WaypointGraph& graph, std::vector<int>& stops) {
  for (std::size_t run = 1; run <= kLongestRun; ++run) {
    for (std::size_t from = 1; from + run <= stops.size(); ++from) {
      if (moveRun(graph, stops, from, run)) return true;
    }
  }
  return false;
}

}  // namespace

void improveOrder(const WaypointGraph& graph, std::vector<int>& stops) {
  while (twoOpt(graph, stops) || orOpt(graph, stops)) {
  }
}

}  // namespace frontier_pilot::bench
