#include "surfaces/line_fitter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace frontier_pilot {
namespace {

constexpr double kTolerance = 0.02;  // [m]

surfaces::SurfacePoints pointsAt(const std::vector<Vec2>& positions) {
  surfaces::SurfacePoints points(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) points[i].position = positions[i];
  return points;
}

/// `count` points a centimetre apart along `heading`, off the line by `noise` [m].
std::vector<Vec2> row(const Vec2& from, double heading, int count, double noise = 0.0, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> off(0.0, 1.0);
  std::vector<Vec2> positions;
  for (int i = 0; i < count; ++i) {
    positions.emplace_back(from + 0.01 * i * direction(heading) + noise * off(random) * direction(heading + kPi / 2.0));
  }
  return positions;
}

TEST(LineFitter, FindsTheNormalOfARowOfPointsWhicheverWayItRuns) {
  for (int i = 0; i < 48; ++i) {
    const double heading = kPi * i / 24.0;
    const auto line = surfaces::LineFitter(pointsAt(row({4.0, -3.0}, heading, 20))).line({0, 19}, kTolerance);
    ASSERT_TRUE(line.has_value()) << heading;
    EXPECT_NEAR(line->normal.norm(), 1.0, 1e-12);
    EXPECT_NEAR(line->normal.dot(direction(heading)), 0.0, 1e-5) << heading;
    EXPECT_NEAR(line->variance, 0.0, 1e-12);
  }
}

TEST(LineFitter, EstimatesTheNoiseOfThePointsWithoutBias) {
  double sum = 0.0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    const auto line = surfaces::LineFitter(pointsAt(row({1.0, 2.0}, 0.4, 12, 0.003, seed))).line({0, 11}, kTolerance);
    ASSERT_TRUE(line.has_value());
    sum += line->variance;
  }
  EXPECT_NEAR(sum / 400.0, 0.003 * 0.003, 0.1 * 0.003 * 0.003);
}

TEST(LineFitter, NeedsThreePoints) {
  const surfaces::LineFitter fitter(pointsAt(row({1.0, 0.0}, 0.0, 5)));
  EXPECT_FALSE(fitter.line({1, 1}, kTolerance).has_value());
  EXPECT_FALSE(fitter.line({1, 2}, kTolerance).has_value());
  EXPECT_TRUE(fitter.line({1, 3}, kTolerance).has_value());
}

TEST(LineFitter, FindsNoLineInPointsThatAreOne) {
  EXPECT_FALSE(
      surfaces::LineFitter(pointsAt({{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}})).line({0, 2}, kTolerance).has_value());
}

TEST(LineFitter, FindsNoLineRoundACornerNorInACloud) {
  std::vector<Vec2> corner = row({0.0, 0.0}, 0.0, 15);
  const std::vector<Vec2> other = row({0.14, 0.01}, kPi / 2.0, 15);
  corner.insert(corner.end(), other.begin(), other.end());
  EXPECT_FALSE(surfaces::LineFitter(pointsAt(corner)).line({0, 29}, kTolerance).has_value());
  EXPECT_FALSE(surfaces::LineFitter(pointsAt(row({0.0, 0.0}, 0.0, 4, 0.02))).line({0, 3}, 1.0).has_value());
}

TEST(LineFitter, LooksAtTheSpanAlone) {
  std::vector<Vec2> positions = row({0.0, 0.0}, 0.0, 15);
  const std::vector<Vec2> other = row({0.14, 0.01}, kPi / 2.0, 15);
  positions.insert(positions.end(), other.begin(), other.end());
  const surfaces::LineFitter fitter(pointsAt(positions));
  const auto first = fitter.line({0, 14}, kTolerance);
  const auto second = fitter.line({15, 29}, kTolerance);
  ASSERT_TRUE(first.has_value() && second.has_value());
  EXPECT_NEAR(std::abs(first->normal.y()), 1.0, 1e-9);
  EXPECT_NEAR(std::abs(second->normal.x()), 1.0, 1e-9);
}

TEST(LineFitter, TakesNoLineThatIsThickerThanAllowed) {
  const surfaces::LineFitter fitter(pointsAt(row({0.0, 0.0}, 0.3, 100, 0.01)));
  EXPECT_TRUE(fitter.line({0, 99}, 0.02).has_value());
  EXPECT_FALSE(fitter.line({0, 99}, 0.005).has_value());
}

TEST(LineFitter, TakesAShortThickSpanForAnArmIfItHasPointsEnough) {
  std::vector<Vec2> positions;
  for (int i = 0; i < 60; ++i) positions.emplace_back(0.001 * i, i % 2 == 0 ? 0.007 : -0.007);
  const surfaces::LineFitter fitter(pointsAt(positions));
  EXPECT_FALSE(fitter.line({0, 59}, kTolerance).has_value());
  EXPECT_TRUE(fitter.arm({0, 59}, kTolerance).has_value());
  EXPECT_FALSE(fitter.arm({0, 9}, kTolerance).has_value()) << "ten points do not say where it leads";
}

}  // namespace
}  // namespace frontier_pilot
