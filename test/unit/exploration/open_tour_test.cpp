#include "exploration/tour/open_tour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace frontier_pilot {
namespace {

/// Stops at random places of a square, `costs.first` from its corner; `skew` is added to the legs that lead out of each
/// second stop, which makes them asymmetric.
exploration::TourCosts randomStops(std::size_t count, unsigned seed, double skew = 0.0) {
  std::mt19937 random(seed);
  std::vector<std::pair<double, double>> places;
  const auto coordinate = [&] { return static_cast<double>(random() % 1000) / 100.0; };
  for (std::size_t i = 0; i < count; ++i) {
    const double x = coordinate();
    places.emplace_back(x, coordinate());
  }
  exploration::TourCosts costs(count);
  for (std::size_t i = 0; i < count; ++i) {
    costs.first[i] = std::hypot(places[i].first, places[i].second);
    for (std::size_t j = 0; j < count; ++j) {
      costs.leg(i, j) = std::hypot(places[i].first - places[j].first, places[i].second - places[j].second);
      if (i % 2 == 1) costs.leg(i, j) += skew;
    }
  }
  return costs;
}

double leastCost(const exploration::TourCosts& costs) {
  exploration::Tour tour(costs.size());
  std::iota(tour.begin(), tour.end(), std::size_t{0});
  double least = std::numeric_limits<double>::infinity();
  do {
    least = std::min(least, exploration::costOf(tour, costs));
  } while (std::next_permutation(tour.begin(), tour.end()));
  return least;
}

bool visitsAllOnce(exploration::Tour tour, std::size_t count) {
  std::sort(tour.begin(), tour.end());
  exploration::Tour all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return tour == all;
}

// [EXP-9]
TEST(OpenTour, IsTheShortestOfAllOrdersForFewStops_EXP_9) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const exploration::TourCosts costs = randomStops(1 + seed % 7, seed, seed % 3);
    const exploration::Tour tour = exploration::solveOpenTour(costs);
    EXPECT_TRUE(visitsAllOnce(tour, costs.size()));
    EXPECT_NEAR(exploration::costOf(tour, costs), leastCost(costs), 1e-9) << "seed " << seed;
  }
}

// [EXP-9]
TEST(OpenTour, PricesTheEndWhenTheRobotHasToComeHome_EXP_9) {
  exploration::TourCosts costs(2);
  costs.first = {1.0, 1.0};
  costs.legs = {0.0, 1.0, 1.0, 0.0};
  costs.last = {5.0, 0.0};
  EXPECT_EQ(exploration::solveOpenTour(costs), (exploration::Tour{0, 1}));
  costs.last = {0.0, 5.0};
  EXPECT_EQ(exploration::solveOpenTour(costs), (exploration::Tour{1, 0}));
}

// [EXP-9]
TEST(OpenTour, OfManyStopsIsNotLengthenedByAnyMoveOfOneStopOrReversal_EXP_9) {
  const exploration::TourCosts costs = randomStops(25, 3);
  const exploration::Tour tour = exploration::solveOpenTour(costs);
  ASSERT_TRUE(visitsAllOnce(tour, costs.size()));
  const double cost = exploration::costOf(tour, costs);
  for (std::size_t i = 0; i < tour.size(); ++i) {
    for (std::size_t j = i + 1; j < tour.size(); ++j) {
      exploration::Tour moved = tour;
      std::rotate(moved.begin() + static_cast<std::ptrdiff_t>(i), moved.begin() + static_cast<std::ptrdiff_t>(i + 1),
                  moved.begin() + static_cast<std::ptrdiff_t>(j + 1));
      EXPECT_GE(exploration::costOf(moved, costs), cost - 1e-9);
      exploration::Tour reversed = tour;
      std::reverse(reversed.begin() + static_cast<std::ptrdiff_t>(i),
                   reversed.begin() + static_cast<std::ptrdiff_t>(j + 1));
      EXPECT_GE(exploration::costOf(reversed, costs), cost - 1e-9);
    }
  }
}

// [EXP-9]
TEST(OpenTour, BeginsWithAGivenStop_EXP_9) {
  for (const std::size_t count : {std::size_t{1}, std::size_t{6}, std::size_t{15}}) {
    const exploration::TourCosts costs = randomStops(count, 5);
    for (std::size_t first = 0; first < count; ++first) {
      const exploration::Tour tour = exploration::solveOpenTour(costs, first);
      EXPECT_EQ(tour.front(), first);
      EXPECT_TRUE(visitsAllOnce(tour, count));
    }
  }
}

TEST(OpenTour, WithoutStopsIsEmpty) {
  EXPECT_TRUE(exploration::solveOpenTour(exploration::TourCosts(0)).empty());
  EXPECT_EQ(exploration::costOf({}, exploration::TourCosts(0)), 0.0);
}

}  // namespace
}  // namespace frontier_pilot
