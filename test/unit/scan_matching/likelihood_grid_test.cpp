#include "scan_matching/likelihood_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "frontier_pilot/scan_matching/correlative_search.h"
#include "frontier_pilot/scan_matching/surface_map.h"

namespace frontier_pilot {
namespace {

double valueAt(const scan_matching::LikelihoodGrid& field, const Vec2& point) {
  return field.grid().get(field.grid().geometry().cellAt(point), 0) / 255.0;
}

TEST(LikelihoodGrid, IsAGaussianOfTheDistanceToTheNearestPoint) {
  scan_matching::LikelihoodGrid field;
  const std::vector<Vec2> points = {{-1.013, 0.02}, {-0.9, 0.031}, {2.0, 3.0}};
  field.add(points);
  const double sigma = field.parameters().sigma;
  for (std::size_t i = 0; i < field.grid().size(); ++i) {
    const Vec2 centre = field.grid().geometry().centre(field.grid().geometry().cell(i));
    double nearest = 1e9;
    for (const Vec2& point : points) nearest = std::min(nearest, (point - centre).norm());
    if (nearest > 2.0 * sigma) continue;
    EXPECT_NEAR(field.grid()[i] / 255.0, std::exp(-0.5 * nearest * nearest / (sigma * sigma)), 0.02);
  }
}

TEST(LikelihoodGrid, KeepsWhatItHasWhenItGrows) {
  scan_matching::LikelihoodGrid field;
  EXPECT_TRUE(field.grid().empty());
  field.add({});
  EXPECT_TRUE(field.grid().empty());
  field.add({{0.025, 0.025}});
  EXPECT_GT(valueAt(field, {0.025, 0.025}), 0.98);
  field.add({{-20.0, 7.0}, {3.0, -11.0}});
  EXPECT_GT(valueAt(field, {0.025, 0.025}), 0.98);
  EXPECT_GT(valueAt(field, {-20.0, 7.0}), 0.7);
  EXPECT_EQ(valueAt(field, {1.0, 1.0}), 0.0);
}

TEST(LikelihoodGrid, IsTheSameAloneAsInAMapOfSurfaces) {
  const surfaces::SurfacePoints points = {{{0.3, 0.2}, {1.0, 0.0}}, {{-4.0, 2.0}, {0.0, 1.0}}};
  scan_matching::SurfaceMap map({0.1, 0.12});
  map.add(points, Pose2());
  const Grid<std::uint8_t> alone = scan_matching::likelihoodField(points, {0.1, 0.12});
  EXPECT_TRUE(alone.geometry() == map.field().geometry());
  EXPECT_TRUE(alone.cells() == map.field().cells());
}

TEST(MaxPyramid, HoldsTheGreatestValueOfEachSquare) {
  GridGeometry geometry;
  geometry.width = 13;
  geometry.height = 6;
  Grid<std::uint8_t> field(geometry);
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = static_cast<std::uint8_t>((i * 7919) % 251);
  const scan_matching::MaxPyramid pyramid(field, 4);
  ASSERT_EQ(pyramid.top(), 4);
  for (int h = 0; h <= 4; ++h) {
    const int side = 1 << h;
    for (int y = -2 * side; y < 6 + side; ++y) {
      for (int x = -2 * side; x < 13 + side; ++x) {
        std::uint8_t greatest = 0;
        for (int j = y; j < y + side; ++j) {
          for (int i = x; i < x + side; ++i) greatest = std::max(greatest, field.get({i, j}, 0));
        }
        EXPECT_EQ(pyramid.level(h).at(x, y), greatest) << "level " << h << " at " << x << ", " << y;
      }
    }
  }
}

}  // namespace
}  // namespace frontier_pilot
