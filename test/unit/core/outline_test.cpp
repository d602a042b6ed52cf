// The outline of a robot: the radii that follow from it, distances, and the cells that it covers.

#include "frontier_pilot/core/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

namespace frontier_pilot {
namespace {

Outline waffle() { return Outline::polygon({{0.077, 0.153}, {-0.205, 0.153}, {-0.205, -0.153}, {0.077, -0.153}}); }

// [ROB-1]
TEST(Outlines, KnowTheRadiiThatFollowFromThem) {
  const Outline outline = waffle();
  EXPECT_FALSE(outline.isDisc());
  EXPECT_NEAR(outline.inscribedRadius(), 0.077, 1e-12);
  EXPECT_NEAR(outline.circumscribedRadius(), std::hypot(0.205, 0.153), 1e-12);
  EXPECT_NEAR(outline.halfWidth(), 0.153, 1e-12);
  EXPECT_NEAR(outline.front(), 0.077, 1e-12);
  EXPECT_NEAR(outline.rear(), 0.205, 1e-12);
  const Outline disc = Outline::disc(0.2);
  for (const double radius : {disc.inscribedRadius(), disc.circumscribedRadius(), disc.halfWidth(), disc.front()}) {
    EXPECT_EQ(radius, 0.2);
  }
}

// [ROB-1] What drives by such an outline would not know its inside from its outside.
TEST(Outlines, ThatCrossOrTouchThemselvesAreRefused_ROB_1) {
  const auto problem = [](const std::vector<Vec2>& corners) { return std::string(Outline::problem(corners)); };
  EXPECT_EQ(problem({{-1.0, -1.0}, {2.0, 1.0}, {2.0, -1.0}, {-1.0, 1.0}}), "crosses or touches itself");
  const std::vector<Vec2> square = {{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}};
  EXPECT_EQ(problem(square), "");
  std::vector<Vec2> twice = square;
  twice.insert(twice.end(), square.begin(), square.end());
  EXPECT_EQ(problem(twice), "crosses or touches itself");
  std::vector<Vec2> round;
  for (int i = 0; i < 1001; ++i) round.push_back(direction(2.0 * kPi * i / 1001));
  EXPECT_EQ(problem(round), "must have at most 1000 corners");
  round.pop_back();
  EXPECT_EQ(problem(round), "");
}

TEST(Outlines, OfADiscHaveAPolygonAroundIt) {
  const Outline disc = Outline::disc(0.2);
  const Outline around = Outline::polygon(disc.corners());
  EXPECT_NEAR(around.inscribedRadius(), 0.2, 1e-12);
  EXPECT_LT(around.circumscribedRadius(), 0.202);
}

TEST(Outlines, GiveTheDistanceToAPointInsideAndOutside) {
  const Outline outline = waffle();
  EXPECT_NEAR(outline.distance({0.177, 0.0}), 0.1, 1e-12);
  EXPECT_NEAR(outline.distance({0.0, 0.0}), -0.077, 1e-12);
  EXPECT_NEAR(outline.distance({0.107, 0.193}), 0.05, 1e-12) << "from the corner";
  EXPECT_NEAR(Outline::disc(0.1).distance({0.0, 0.3}), 0.2, 1e-12);
}

TEST(Outlines, GiveTheNearestPlaceOnTheirEdgeAndHowFarTheyReach) {
  const Outline box = Outline::polygon({{0.3, 0.2}, {-0.1, 0.2}, {-0.1, -0.2}, {0.3, -0.2}});
  EXPECT_NEAR((box.nearestTo({1.0, 0.1}) - Vec2(0.3, 0.1)).norm(), 0.0, 1e-9);
  EXPECT_EQ(box.nearestTo({1.0, 1.0}), Vec2(0.3, 0.2));
  EXPECT_DOUBLE_EQ(box.reach({1.0, 0.0}), 0.3);
  EXPECT_DOUBLE_EQ(box.reach({-1.0, 0.0}), 0.1);
  EXPECT_DOUBLE_EQ(box.reach({0.6, 0.8}), 0.34);
  EXPECT_NEAR((Outline::disc(0.2).nearestTo({3.0, 4.0}) - Vec2(0.12, 0.16)).norm(), 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(Outline::disc(0.2).reach({0.6, 0.8}), 0.2);
}

TEST(Outlines, GiveWhereARayLeavesThem) {
  EXPECT_NEAR(waffle().distanceToEdge({-0.064, 0.0}, {1.0, 0.0}), 0.141, 1e-12);
  EXPECT_NEAR(waffle().distanceToEdge({-0.064, 0.0}, {0.0, -1.0}), 0.153, 1e-12);
  EXPECT_EQ(waffle().distanceToEdge({0.1, 0.0}, {1.0, 0.0}), 0.0) << "from outside";
  EXPECT_NEAR(Outline::disc(0.1).distanceToEdge({0.06, 0.0}, {0.0, 1.0}), 0.08, 1e-12);
}

TEST(Outlines, GrowByAMarginOnEverySide) {
  const Outline padded = waffle().padded(0.01);
  EXPECT_NEAR(padded.front(), 0.087, 1e-12);
  EXPECT_NEAR(padded.rear(), 0.215, 1e-12);
  EXPECT_NEAR(padded.halfWidth(), 0.163, 1e-12);
  EXPECT_NEAR(Outline::disc(0.1).padded(0.01).circumscribedRadius(), 0.11, 1e-12);
}

TEST(Outlines, RefuseWhatIsNoOutline) {
  EXPECT_THROW(Outline::polygon({{0.1, 0.0}, {-0.1, 0.0}}), std::invalid_argument);
  EXPECT_THROW(Outline::polygon({{0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}}), std::invalid_argument);
  EXPECT_THROW(Outline::polygon({{1.1, 1.1}, {0.9, 1.1}, {1.0, 0.9}}), std::invalid_argument);
  const Outline clockwise = Outline::polygon({{0.1, -0.1}, {-0.1, -0.1}, {-0.1, 0.1}, {0.1, 0.1}});
  EXPECT_NEAR(clockwise.padded(0.05).halfWidth(), 0.15, 1e-12);
}

// A law, at random poses: a cell whose centre lies within the outline is covered, and a covered one lies within its own
// half diagonal of it.
TEST(Outlines, CoverTheCellsThatTheyTouch) {
  const Outline outline = waffle();
  GridGeometry geometry;
  geometry.resolution = 0.05;
  geometry.width = geometry.height = 40;
  geometry.origin = Vec2(-1.0, -1.0);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-0.5, 0.5);
  std::vector<Cell> covered;
  for (int i = 0; i < 50; ++i) {
    const Pose2 pose(any(random), any(random), 6.0 * any(random));
    outline.cellsAt(pose, geometry, covered);
    for (int y = 0; y < geometry.height; ++y) {
      for (int x = 0; x < geometry.width; ++x) {
        const double distance = outline.distance(pose.inverse() * geometry.centre({x, y}));
        const bool is_covered = std::find(covered.begin(), covered.end(), Cell{x, y}) != covered.end();
        EXPECT_TRUE(is_covered || distance >= 0.0);
        EXPECT_FALSE(is_covered && distance > 0.0354);
      }
    }
  }
}

}  // namespace
}  // namespace frontier_pilot
