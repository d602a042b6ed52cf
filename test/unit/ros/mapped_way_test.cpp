// Whether a robot has mapped on since its map was saved. [FLT-2]

#include "ros/common/maps/mapped_way.h"

#include <gtest/gtest.h>

#include <chrono>

namespace frontier_pilot {
namespace {

class MappedWayOfARobot : public ::testing::Test {
 protected:
  /// It maps while it drives so far along x [m].
  void drive(double distance) {
    for (double driven = 0.0; driven < distance; driven += 0.02) way_.note({x_ += 0.02, 0.0});
  }
  /// Whether it has mapped on an hour later.
  bool hasGoneOn() const { return way_.hasGoneOn(at_ + std::chrono::hours(1)); }

  MappedWay way_;
  double x_ = 0.0;
  const SteadyTime at_{std::chrono::hours(1)};
};

// [FLT-2]
TEST_F(MappedWayOfARobot, IsSavedAsLongAsItStands_FLT_2) {
  drive(3.0);
  EXPECT_FALSE(way_.wasSaved());
  EXPECT_FALSE(hasGoneOn()) << "nothing was saved";
  way_.noteSaved(way_.steps(), at_);
  EXPECT_TRUE(way_.wasSaved());
  for (int i = 0; i < 10000; ++i) way_.note({x_ + 0.01 * (i % 2), 0.0});
  EXPECT_FALSE(hasGoneOn());
}

// [FLT-2]
TEST_F(MappedWayOfARobot, IsNotSavedAnyMoreWhenItHasDrivenOn_FLT_2) {
  drive(3.0);
  const std::uint64_t when_it_was_copied = way_.steps();
  drive(0.5);
  way_.noteSaved(when_it_was_copied, at_);
  EXPECT_TRUE(hasGoneOn()) << "while the map was written";
  way_.noteSaved(way_.steps(), at_);
  EXPECT_FALSE(hasGoneOn());
  drive(0.5);
  EXPECT_TRUE(hasGoneOn());
}

// scripts/run saves the map while the robot drives, and ends the nodes then. [FLT-2]
TEST_F(MappedWayOfARobot, IsSavedForAFewSecondsInWhichItDrivesOn_FLT_2) {
  drive(3.0);
  way_.noteSaved(way_.steps(), at_);
  drive(3.0);
  EXPECT_FALSE(way_.hasGoneOn(at_ + std::chrono::seconds(5)));
  EXPECT_TRUE(way_.hasGoneOn(at_ + std::chrono::seconds(20)));
}

}  // namespace
}  // namespace frontier_pilot
