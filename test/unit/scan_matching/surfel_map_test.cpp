#include "scan_matching/surfel_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace frontier_pilot {
namespace {

/// Points every centimetre along 3 m of a wall at `y` that faces +y, seen `times` times with noise [m].
scan_matching::SurfelMap wallAt(double y, int times, double noise) {
  std::mt19937 random(1);
  std::normal_distribution<double> off;
  scan_matching::SurfelMap map;
  for (int i = 0; i < times; ++i) {
    surfaces::SurfacePoints points;
    for (int k = 0; k < 300; ++k) points.push_back({Vec2(0.01 * k, y + noise * off(random)), Vec2(0.0, 1.0)});
    map.add(points, Pose2());
  }
  return map;
}

TEST(SurfelMap, MAP_1_IsOneWallWhereverInItsRasterThatStands) {
  for (int i = 0; i < 60; ++i) {
    const double y = 1.0 + 0.01 * i;
    const scan_matching::SurfelMap map = wallAt(y, 20, 0.01);
    EXPECT_LT(map.size(), 60U) << "for a wall at " << y;
    for (int k = 0; k < 300; ++k) {
      const scan_matching::Surfel* surfel = map.nearest({Vec2(0.01 * k, y), Vec2(0.0, 1.0)});
      ASSERT_TRUE(surfel) << "at " << y;
      EXPECT_NEAR(surfel->position().y(), y, 0.003) << "as the mean of what was seen of it";
    }
  }
}

TEST(SurfelMap, MAP_1_KeepsTheTwoSidesOfAThinWallApart) {
  scan_matching::SurfelMap map = wallAt(1.0, 5, 0.005);
  surfaces::SurfacePoints behind;
  for (int k = 0; k < 300; ++k) behind.push_back({Vec2(0.01 * k, 0.98), Vec2(0.0, -1.0)});
  map.add(behind, Pose2());
  EXPECT_NEAR(map.nearest({Vec2(1.5, 0.99), Vec2(0.0, 1.0)})->position().y(), 1.0, 0.003);
  EXPECT_NEAR(map.nearest({Vec2(1.5, 0.99), Vec2(0.0, -1.0)})->position().y(), 0.98, 0.003);
}

TEST(SurfelMap, MAP_1_BelievesMoreWhatIsKnownBetter) {
  scan_matching::SurfelMap map;
  map.add({{Vec2(1.0, 1.0), Vec2(0.0, 1.0), false, 1e-6}}, Pose2());
  map.add({{Vec2(1.0, 1.03), Vec2(0.0, 1.0), false, 1e-4}}, Pose2());
  EXPECT_NEAR(map.nearest({Vec2(1.0, 1.0), Vec2(0.0, 1.0)})->position().y(), 1.0, 0.001);
}

TEST(SurfelMap, FindsASurfelThatHasMovedOnSinceItWasBegun) {
  // Begun at places 1.5 cm apart, some of them near a tile's border, and then moved nearly 4 cm along the wall.
  const Vec2 up(0.0, 1.0);
  for (int i = 0; i < 40; ++i) {
    const double x = 0.015 * i;
    scan_matching::SurfelMap map;
    map.add({{Vec2(x, 1.0), up}}, Pose2());
    for (int k = 0; k < 20; ++k) map.add({{Vec2(x - 0.04, 1.0), up}}, Pose2());
    ASSERT_EQ(map.size(), 1U);
    EXPECT_TRUE(map.nearest({Vec2(x - 0.17, 1.0), up})) << x;
    EXPECT_TRUE(map.nearest({Vec2(x + 0.10, 1.0), up})) << x;
    EXPECT_FALSE(map.nearest({Vec2(x + 0.15, 1.0), up})) << x;
  }
}

TEST(SurfelMap, MAP_1_SharpensWhatItHasAndAddsNothing) {
  scan_matching::SurfelMap map = wallAt(1.0, 1, 0.0);
  const std::size_t size = map.size();
  surfaces::SurfacePoints points = {{Vec2(1.0, 2.0), Vec2(0.0, 1.0)}};
  for (int k = 0; k < 300; ++k) points.push_back({Vec2(0.01 * k, 1.02), Vec2(0.0, 1.0)});
  map.updateKnown(points, Pose2());
  EXPECT_EQ(map.size(), size);
  EXPECT_NEAR(map.nearest({Vec2(1.5, 1.0), Vec2(0.0, 1.0)})->position().y(), 1.01, 0.001);
  EXPECT_FALSE(map.nearest(points.front()));
}

TEST(SurfelMap, FindsNothingThatIsFarOrLooksAnotherWay) {
  const scan_matching::SurfelMap map = wallAt(1.0, 1, 0.001);
  EXPECT_FALSE(map.nearest({Vec2(1.5, 1.2), Vec2(0.0, 1.0)}));
  EXPECT_FALSE(map.nearest({Vec2(1.5, 1.0), Vec2(1.0, 0.0)}));
  EXPECT_FALSE(map.nearest({Vec2(1.5, 1.0), Vec2(0.0, 0.0)}));
}

}  // namespace
}  // namespace frontier_pilot
