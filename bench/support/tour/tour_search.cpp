#include "support/tour/tour_search.h"

#include <algorithm>
#include <cmath>

#include "support/tour/stop_order.h"

namespace frontier_pilot::bench {
namespace {

constexpr int kMostRemoved = 8;       ///< stops in a round
constexpr double kWorstKept = 0.015;  ///< by how much a worse way may replace another one at first, as a share of it
constexpr double kWorthPruning = 1.04;
constexpr double kLeastDetour = 0.1;  ///< a stop on the way costs as much as this detour [m]

}  // namespace

TourSearch::TourSearch(const WaypointGraph& graph, const std::vector<View>& views, const FloorBits& floor, int needed)
    : graph_(graph), views_(views), floor_(floor), needed_(needed) {}

double TourSearch::length(const Stops& stops) const {
  double sum = 0.0;
  for (std::size_t i = 1; i < stops.size(); ++i) sum += graph_.distance(stops[i - 1], stops[i]);
  return sum;
}

std::vector<int> TourSearch::wayThrough(const Stops& stops) const {
  std::vector<int> way{stops.front()};
  for (std::size_t i = 1; i < stops.size(); ++i) graph_.appendWay(stops[i - 1], stops[i], way);
  return way;
}

FloorBits::Bits TourSearch::missing(const Stops& stops) const {
  FloorBits::Bits bits = floor_.all();
  for (const int node : wayThrough(stops)) exclude(views_[static_cast<std::size_t>(node)], bits);
  return bits;
}

int TourSearch::lack(const FloorBits::Bits& missing) const { return needed_ - (floor_.count() - countOf(missing)); }

/// The cheapest place for `node` on the way. `legs[i]`: the length from stop i to the next one [m].
TourSearch::Insertion TourSearch::cheapest(const Stops& stops, const std::vector<double>& legs, int node) const {
  Insertion best{node, stops.size(), graph_.distance(node, stops.back())};
  double before = graph_.distance(node, stops.front());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const double after = graph_.distance(node, stops[i + 1]);
    const double detour = before + after - legs[i];
    if (detour < best.detour) best = {node, i + 1, detour};
    before = after;
  }
  return best;
}

TourSearch::Insertion TourSearch::bestInsertion(const Stops& stops, const FloorBits::Bits& missing, int lack) {
  const double power = 0.01 * random_.between(50, 100);
  std::vector<double> legs;
  for (std::size_t i = 1; i < stops.size(); ++i) legs.push_back(graph_.distance(stops[i - 1], stops[i]));
  Insertion best;
  double best_score = 0.0;
  for (int node = 0; node < graph_.size(); ++node) {
    const int shown = std::min(lack, common(views_[static_cast<std::size_t>(node)], missing));
    if (shown == 0) continue;
    const Insertion insertion = cheapest(stops, legs, node);
    const double noise = 1.0 + 0.004 * random_.between(0, 100);
    const double score = noise * std::pow(shown, power) / (std::max(0.0, insertion.detour) + kLeastDetour);
    if (score <= best_score) continue;
    best_score = score;
    best = insertion;
  }
  return best;
}

void TourSearch::repair(Stops& stops) {
  FloorBits::Bits left = missing(stops);
  for (int lacking = lack(left); lacking > 0; lacking = lack(left)) {
    const Insertion insertion = bestInsertion(stops, left, lacking);
    if (insertion.node < 0) return;  // nothing more can be seen from anywhere
    stops.insert(stops.begin() + static_cast<std::ptrdiff_t>(insertion.before), insertion.node);
    left = missing(stops);
  }
}

// Takes out neighbours in the order of the way, or those nearest to one of them.
TourSearch::Stops TourSearch::destroyed(const Stops& stops) {
  Stops kept = stops;
  const int most = std::min(kMostRemoved, static_cast<int>(stops.size()) - 1);
  const int removed = random_.between(1, most);
  const int seed = random_.between(1, static_cast<int>(stops.size()) - 1);
  if (random_.chance(50)) {
    const int first = std::min(seed, static_cast<int>(stops.size()) - removed);
    kept.erase(kept.begin() + first, kept.begin() + first + removed);
    return kept;
  }
  const int centre = stops[static_cast<std::size_t>(seed)];
  for (int i = 0; i < removed; ++i) {
    kept.erase(std::min_element(kept.begin() + 1, kept.end(),
                                [&](int a, int b) { return graph_.distance(centre, a) < graph_.distance(centre, b); }));
  }
  return kept;
}

void TourSearch::prune(Stops& stops) const {
  for (std::size_t i = stops.size(); i-- > 1;) {
    Stops without = stops;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
    if (seesEnough(without)) stops = std::move(without);
  }
}

std::vector<int> TourSearch::run(int rounds) {
  Stops current{0};
  repair(current);
  Stops best = current;
  for (int round = 0; round < rounds && current.size() > 1; ++round) {
    Stops next = destroyed(current);
    repair(next);
    improveOrder(graph_, next);
    if (length(next) > kWorthPruning * length(best)) continue;
    repair(next);  // another order leads through other waypoints, which may show less
    prune(next);
    const double tolerance = kWorstKept * (1.0 - static_cast<double>(round) / rounds);
    if (length(next) > (1.0 + tolerance) * length(best)) continue;
    current = std::move(next);
    if (length(current) < length(best)) best = current;
  }
  return wayThrough(best);
}

}  // namespace frontier_pilot::bench
