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

/// Improves a tour by local changes: Or-opt, which moves up to three stops, and 2-opt, which reverses a part. What a
/// change saves follows from the steps at its ends, and from the costs of the part in both directions.
class LocalSearch {
 public:
  LocalSearch(const TourCosts& costs, Tour& tour) : costs_(costs), tour_(tour) { sumUp(); }

  void improve() {
    constexpr int kMaxRounds = 50;
    for (int round = 0; round < kMaxRounds && (moveOne() || reverseOne()); ++round) {
    }
  }

 private:
  static constexpr std::size_t kNone =
      std::numeric_limits<std::size_t>::max();  ///< before the first and after the last

  bool moveOne() {
    constexpr std::size_t kMostMoved = 3;
    bool any = false;
    for (std::size_t length = 1; length <= std::min(kMostMoved, tour_.size()); ++length) {
      for (std::size_t from = 0; from + length <= tour_.size(); ++from) {
        for (std::size_t to = 0; to + length <= tour_.size(); ++to) {
          for (const bool reversed : {false, true}) {
            if (to == from && (!reversed || length == 1)) continue;
            if (addedByMove(from, length, to, reversed) >= -kEnough) continue;
            move(from, length, to, reversed);
            any = true;
          }
        }
      }
    }
    return any;
  }

  bool reverseOne() {
    bool any = false;
    for (std::size_t begin = 0; begin + 1 < tour_.size(); ++begin) {
      for (std::size_t end = begin + 2; end <= tour_.size(); ++end) {
        const std::size_t before = stopBefore(begin), first = tour_[begin], last = tour_[end - 1], after = stopAt(end);
        const double added = step(before, last) + step(first, after) - step(before, first) - step(last, after) +
                             backward(begin, end) - forward(begin, end);
        if (added >= -kEnough) continue;
        std::reverse(at(begin), at(end));
        sumUp();
        any = true;
      }
    }
    return any;
  }

  /// What moving tour[from, from + length) so that it begins at `to` adds to the cost.
  double addedByMove(std::size_t from, std::size_t length, std::size_t to, bool reversed) const {
    const std::size_t end = from + length;
    const std::size_t before = stopBefore(from), after = stopAt(end);
    // The stops between which the part comes to lie, once it has been taken out.
    const std::size_t left = to <= from ? stopBefore(to) : tour_[to + length - 1];
    const std::size_t right = to < from ? tour_[to] : stopAt(to + length);
    const std::size_t first = reversed ? tour_[end - 1] : tour_[from];
    const std::size_t last = reversed ? tour_[from] : tour_[end - 1];
    const double taken_out = step(before, after) - step(before, tour_[from]) - step(tour_[end - 1], after);
    const double put_in = step(left, first) + step(last, right) - step(left, right);
    return taken_out + put_in + (reversed ? backward(from, end) - forward(from, end) : 0.0);
  }

  void move(std::size_t from, std::size_t length, std::size_t to, bool reversed) {
    if (to < from) {
      std::rotate(at(to), at(from), at(from + length));
    } else {
      std::rotate(at(from), at(from + length), at(to + length));
    }
    if (reversed) std::reverse(at(to), at(to + length));
    sumUp();
  }

  Tour::iterator at(std::size_t position) { return tour_.begin() + static_cast<std::ptrdiff_t>(position); }
  std::size_t stopAt(std::size_t position) const { return position < tour_.size() ? tour_[position] : kNone; }
  std::size_t stopBefore(std::size_t position) const { return position > 0 ? tour_[position - 1] : kNone; }

  double step(std::size_t from, std::size_t to) const {
    if (from == kNone) return to == kNone ? 0.0 : costs_.first[to];
    return to == kNone ? costs_.last[from] : costs_.leg(from, to);
  }
  double forward(std::size_t begin, std::size_t end) const { return forward_[end - 1] - forward_[begin]; }
  double backward(std::size_t begin, std::size_t end) const { return backward_[end - 1] - backward_[begin]; }

  void sumUp() {
    forward_.assign(tour_.size(), 0.0);
    backward_.assign(tour_.size(), 0.0);
    for (std::size_t i = 1; i < tour_.size(); ++i) {
      forward_[i] = forward_[i - 1] + costs_.leg(tour_[i - 1], tour_[i]);
      backward_[i] = backward_[i - 1] + costs_.leg(tour_[i], tour_[i - 1]);
    }
  }

  const TourCosts& costs_;
  Tour& tour_;
  std::vector<double> forward_;   ///< cost of the steps from the first stop to each
  std::vector<double> backward_;  ///< cost of the steps from each stop to the first
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
  LocalSearch(costs, tour).improve();
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
