#include "exploration/frontier_goals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "exploration/frontier_evaluator.h"
#include "exploration/tour/passages.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

/// A hall of 6 m x 1.5 m, of which the right end is unknown, with the robot at its left end.
class GoalsOfFrontiers : public ::testing::Test {
 protected:
  GoalsOfFrontiers() {
    GridGeometry geometry;
    geometry.width = 120;
    geometry.height = 30;
    map_ = OccupancyGrid(geometry, kFree);
    fill({0, 0, 120, 1}, kOccupied);
    fill({0, 29, 120, 1}, kOccupied);
    fill({0, 0, 1, 30}, kOccupied);
    fill({110, 1, 10, 28}, kUnknown);
  }

  void fill(const CellRect& rect, std::int8_t value) {
    for (int y = rect.y; y < rect.y + rect.height; ++y) std::fill_n(map_.row(y) + rect.x, rect.width, value);
  }
  bool anySelectable(const CellRect& changed) {
    evaluator_.setMap(map_, changed);
    exploration::FrontierEvaluator::Context context;
    context.robot = context.start = {0.5, 0.75};
    context.history = &history_;
    return evaluator_.evaluate(context);
  }

  OccupancyGrid map_;
  exploration::GoalHistory history_{exploration::BlacklistParameters{}, 1};
  exploration::FrontierEvaluator evaluator_{exploration::FrontierParameters{}, RobotModel{}.drivenOutline()};
};

// Near the frontier neither the map changes nor what lies on the robot's side of the wall; only what can be reached.
// [EXP-3]
TEST_F(GoalsOfFrontiers, AreFoundAsSoonAsAWayOpensFarFromTheFrontier) {
  const CellRect door{30, 60, 1, 29};
  GridGeometry geometry = map_.geometry();
  geometry.height = 90;
  const OccupancyGrid hall = std::exchange(map_, OccupancyGrid(geometry, kOccupied));
  for (int y = 0; y < hall.height(); ++y) std::copy_n(hall.row(y), hall.width(), map_.row(y));
  fill({98, 1, 1, 28}, kOccupied);  // hides the frontier from the robot's side
  fill({1, 60, 109, 29}, kFree);    // a corridor beside the hall, with a passage to it at either end
  fill({1, 29, 20, 31}, kFree);
  fill({99, 29, 11, 31}, kFree);
  fill(door, kOccupied);
  EXPECT_FALSE(anySelectable(map_.geometry().rect()));
  EXPECT_FALSE(anySelectable({}));
  fill(door, kFree);
  EXPECT_TRUE(anySelectable(door));
}

// [EXP-3]
TEST_F(GoalsOfFrontiers, AreFoundAsSoonAsTheFrontierIsNoLongerHidden) {
  const CellRect wall{108, 1, 1, 28};
  fill(wall, kOccupied);
  EXPECT_FALSE(anySelectable(map_.geometry().rect()));
  EXPECT_FALSE(anySelectable({}));
  fill(wall, kFree);
  EXPECT_TRUE(anySelectable(wall));
}

// [EXP-3]
TEST_F(GoalsOfFrontiers, AreLostWhenTheWayIsClosed) {
  const CellRect wall{30, 1, 1, 28};
  EXPECT_TRUE(anySelectable(map_.geometry().rect()));
  fill(wall, kOccupied);
  EXPECT_FALSE(anySelectable(wall));
}

// [EXP-9]
TEST_F(GoalsOfFrontiers, LieInAPassageUntilTheFloorNearbyIsKnownToBeWide) {
  exploration::Passages passages;
  exploration::ObservedMap observed;
  const CellRect side{60, 11, 60, 18};
  fill(side, kOccupied);
  observed.update(map_, map_.geometry().rect());
  EXPECT_TRUE(passages.contains({109, 5}, observed));
  fill(side, kFree);
  observed.update(map_, side);
  EXPECT_FALSE(passages.contains({109, 5}, observed));
}

}  // namespace
}  // namespace frontier_pilot
