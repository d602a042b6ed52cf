#include "exploration/tour/frontier_views.h"

#include <gtest/gtest.h>

#include <string>

#include "support/ascii_world.h"

namespace frontier_pilot {
namespace {

/// Free floor of 12 m x 10 m with nothing known around it.
test::AsciiWorld openFloor() {
  std::string drawing = std::string(142, '?') + "\n";
  for (int row = 0; row < 100; ++row) drawing += std::string(10, '?') + std::string(120, '.') + "????????????\n";
  return test::drawWorld(drawing + std::string(142, '?'), 0.1);
}

/// A cell of the floor, another one for each number.
Cell viewpoint(int number) { return {20 + number % 100, 10 + number / 100}; }

// [EXP-9] [FLT-1]
TEST(FrontierViews, AreCastForManyViewpointsOverSeveralDecisions_EXP_9_FLT_1) {
  constexpr int kViewpoints = 1000;
  const test::AsciiWorld world = openFloor();
  exploration::ObservedMap map;
  map.update(world.map, world.map.geometry().rect());
  exploration::FrontierViews views{exploration::ViewParameters()};
  const auto see = [&] {
    views.beginDecision();
    int seeing = 0;
    for (int i = 0; i < kViewpoints; ++i) seeing += views.from(viewpoint(i), map).empty() ? 0 : 1;
    return seeing;
  };
  const int first = see();
  EXPECT_GT(first, 10);
  EXPECT_LT(first, kViewpoints / 2);
  EXPECT_FALSE(views.from(viewpoint(0), map).empty()) << "the most important ones come first";
  EXPECT_EQ(see(), 2 * first);
  for (int decision = 0; decision < kViewpoints / first; ++decision) see();
  EXPECT_EQ(see(), kViewpoints);
}

}  // namespace
}  // namespace frontier_pilot
