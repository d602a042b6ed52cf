#include "exploration/tour/open_tour.h"

#include <algorithm>
#include <limits>

namespace frontier_pilot::exploration {
namespace {

constexpr std::size_t kMostForExact = 9;
constexpr double kEnough = 1e-9;  ///< a change must shorten the tour by more than rounding errors

/// Held and Karp's table: the cheapest way to have visited a set of stops, by the last of them.
class ExactTour {
 public:
  explicit ExactTour(const TourCosts& costs)
      : costs_(costs), stops_(costs.size()), best_((std::size_t{1} << stops_) * stops_, kNever) {}

  Tour solve() {
    for (std::size_t stop = 0; stop < stops_; ++stop) cost(std::size_t{1} << stop, stop) = costs_.first[stop];
    const std::size_t all = (std::size_t{1} << stops_) - 1;
    for (std::size_t set = 1; set <= all; ++set) extend(set);
    return wayBack(all);
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  double& cost(std::size_t set, std::size_t last) { return best_[set * stops_ + last]; }

  void extend(std::size_t set) {
    for (std::size_t last = 0; last < stops_; ++last) {
      if ((set >> last & 1U) == 0) continue;
      for (std::size_t next = 0; next < stops_; ++next) {
        if ((set >> next & 1U) != 0) continue;
        double& known = cost(set | std::size_t{1} << next, next);
        known = std::min(known, cost(set, last) + costs_.leg(last, next));
      }
    }
  }

  Tour wayBack(std::size_t set) {
    std::size_t stop = 0;
    for (std::size_t i = 1; i < stops_; ++i) {
      if (cost(set, i) + costs_.last[i] < cost(set, stop) + costs_.last[stop]) stop = i;
    }
    Tour tour{stop};
    while (tour.size() < stops_) {
      const std::size_t before = set & ~(std::size_t{1} << stop);
      std::size_t previous = stops_;
      for (std::size_t i = 0; i < stops_; ++i) {
        if ((before >> i & 1U) == 0) continue;
        if (previous == stops_ ||
            cost(before, i) + costs_.leg(i, stop) < cost(before, previous) + costs_.leg(previous, stop)) {
          previous = i;
        }
      }
      set = before;
      stop = previous;
      tour.push_back(stop);
    }
    return {tour.rbegin(), tour.rend()};
  }

  const TourCosts& costs_;
  std::size_t stops_;
  std::vector<double> best_;
};

/// The cost of the step from the stop at `position` - 1 to that at `position`; the first step begins at the beginning,
/// and the one behind the last stop is the end.
double stepCost(const TourCosts& costs, const Tour& tour, std::size_t position) {
  if (position == tour.size()) return costs.last[tour.back()];
  return position == 0 ? costs.first[tour[0]] : costs.leg(tour[position - 1], tour[position]);
}

Tour insertCheapest(const TourCosts& costs) {
  const std::size_t stops = costs.size();
  Tour tour;
  std::vector<bool> visited(stops, false);
  while (tour.size() < stops) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t chosen = 0, place = 0;
    for (std::size_t stop = 0; stop < stops; ++stop) {
      if (visited[stop]) continue;
      for (std::size_t at = 0; at <= tour.size(); ++at) {
        const double in = at == 0 ? costs.first[stop] : costs.leg(tour[at - 1], stop);
        const double out = at == tour.size() ? costs.last[stop] : costs.leg(stop, tour[at]);
        const double added = in + out - (tour.empty() ? 0.0 : stepCost(costs, tour, at));
        if (added >= least) continue;
        least = added;
        chosen = stop;
        place = at;
      }
    }
    tour.insert(tour.begin() + static_cast<std::ptrdiff_t>(place), chosen);
    visited[chosen] = true;
  }
  return tour;
}

/// Improves a tour by local changes.
class LocalSearch {
 public:
  explicit LocalSearch(const TourCosts& costs) : costs_(costs) {}

  void improve(Tour& tour) {
    constexpr int kMaxRounds = 50;
    for (int round = 0; round < kMaxRounds && (moveOne(tour) || reverseOne(tour)); ++round) {
    }
  }

 private:
  bool moveOne(Tour& tour) {
    constexpr std::size_t kMostMoved = 3;
    double cost = costOf(tour, costs_);
    bool any = false;
    for (std::size_t length = 1; length <= std::min(kMostMoved, tour.size()); ++length) {
      for (std::size_t from = 0; from + length <= tour.size(); ++from) {
        for (std::size_t to = 0; to + length <= tour.size(); ++to) {
          for (const bool reversed : {false, true}) {
            if (to == from && (!reversed || length == 1)) continue;
            any = take(moved(tour, from, length, to, reversed), tour, cost) || any;
          }
        }
      }
    }
    return any;
  }

  bool reverseOne(Tour& tour) {
    double cost = costOf(tour, costs_);
    bool any = false;
    for (std::size_t begin = 0; begin + 1 < tour.size(); ++begin) {
      for (std::size_t end = begin + 2; end <= tour.size(); ++end) {
        candidate_ = tour;
        std::reverse(candidate_.begin() + static_cast<std::ptrdiff_t>(begin),
                     candidate_.begin() + static_cast<std::ptrdiff_t>(end));
        any = take(candidate_, tour, cost) || any;
      }
    }
    return any;
  }

  const Tour& moved(const Tour& tour, std::size_t from, std::size_t length, std::size_t to, bool reversed) {
    candidate_ = tour;
    const auto at = [&](std::size_t i) { return candidate_.begin() + static_cast<std::ptrdiff_t>(i); };
    if (to < from) {
      std::rotate(at(to), at(from), at(from + length));
    } else {
      std::rotate(at(from), at(from + length), at(to + length));
    }
    if (reversed) std::reverse(at(to), at(to + length));
    return candidate_;
  }

  bool take(const Tour& candidate, Tour& tour, double& cost) const {
    const double now = costOf(candidate, costs_);
    if (now >= cost - kEnough) return false;
    tour = candidate;
    cost = now;
    return true;
  }

  const TourCosts& costs_;
  Tour candidate_;
};

}  // namespace

double costOf(const Tour& tour, const TourCosts& costs) {
  double sum = 0.0;
  if (tour.empty()) return sum;
  for (std::size_t position = 0; position <= tour.size(); ++position) sum += stepCost(costs, tour, position);
  return sum;
}

Tour solveOpenTour(const TourCosts& costs) {
  if (costs.size() == 0) return {};
  if (costs.size() <= kMostForExact) return ExactTour(costs).solve();
  Tour tour = insertCheapest(costs);
  LocalSearch(costs).improve(tour);
  return tour;
}

Tour solveOpenTour(const TourCosts& costs, std::size_t first) {
  TourCosts rest(costs.size() - 1);
  const auto whole = [&](std::size_t stop) { return stop < first ? stop : stop + 1; };
  for (std::size_t i = 0; i < rest.size(); ++i) {
    rest.first[i] = costs.leg(first, whole(i));
    rest.last[i] = costs.last[whole(i)];
    for (std::size_t j = 0; j < rest.size(); ++j) rest.leg(i, j) = costs.leg(whole(i), whole(j));
  }
  Tour tour{first};
  for (const std::size_t stop : solveOpenTour(rest)) tour.push_back(whole(stop));
  return tour;
}

}  // namespace frontier_pilot::exploration
