#include "surfaces/span_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace frontier_pilot {
namespace {

/// The definition of SpanFinder::around, point by point.
surfaces::Span pointByPoint(const surfaces::SurfacePoints& points, std::size_t i, double radius) {
  const auto belongs = [&](std::size_t j, std::size_t count) {
    return count < 2 || (points[j].position - points[i].position).squaredNorm() <= radius * radius;
  };
  surfaces::Span span{i, i};
  while (points[span.first].connected && belongs(span.first - 1, i - span.first)) --span.first;
  while (span.last + 1 < points.size() && points[span.last + 1].connected && belongs(span.last + 1, span.last - i)) {
    ++span.last;
  }
  return span;
}

/// A line that wanders in steps of up to `step` [m], and breaks off now and then.
surfaces::SurfacePoints wander(std::size_t count, double step, std::mt19937& random) {
  std::uniform_real_distribution<double> any(-step, step);
  surfaces::SurfacePoints points;
  Vec2 at = Vec2::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    at += Vec2(any(random), any(random));
    points.push_back({at, Vec2::Zero(), i > 0 && random() % 500 != 0});
  }
  return points;
}

TEST(SpanFinder, MAP_1_FindsWhatLooksAtPointAfterPointWouldFind) {  // [MAP-1]
  std::mt19937 random(1);
  for (const std::size_t count : {1U, 2U, 5U, 16U, 17U, 300U, 3000U}) {
    for (const double step : {0.0005, 0.005, 0.05, 0.5}) {
      const surfaces::SurfacePoints points = wander(count, step, random);
      const surfaces::SpanFinder finder(points);
      for (std::size_t i = 0; i < count; ++i) {
        for (const double radius : {0.05, 0.1, 0.2, 3.0}) {
          const surfaces::Span wanted = pointByPoint(points, i, radius);
          const surfaces::Span found = finder.around(i, radius);
          ASSERT_EQ(found.first, wanted.first) << count << ", " << step << ", " << i << ", " << radius;
          ASSERT_EQ(found.last, wanted.last) << count << ", " << step << ", " << i << ", " << radius;
        }
      }
    }
  }
}

TEST(RangeMaximum, IsTheGreatestOfAnySpan) {
  std::mt19937 random(2);
  std::vector<double> values;
  for (int i = 0; i < 500; ++i) values.push_back(static_cast<double>(random() % 1000));
  const surfaces::RangeMaximum greatest(values);
  for (int i = 0; i < 5000; ++i) {
    const auto [first, last] = std::minmax({random() % 500, random() % 500});
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(first);
    const auto to = values.begin() + static_cast<std::ptrdiff_t>(last);
    ASSERT_EQ(greatest({first, last}), *std::max_element(from, to + 1));
  }
}

}  // namespace
}  // namespace frontier_pilot
