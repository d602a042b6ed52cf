#include "navigation/neighbours.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

constexpr double kEachRadius = 0.1;  // [m], of both

const Outline kEach = Outline::disc(kEachRadius);  // a check refers to it

/// Another robot around `place`, as one at the origin sees it.
navigation::Neighbours seenAt(const Vec2& place, const Vec2& velocity = Vec2::Zero()) {
  return {{}, {{{place, velocity, kEachRadius}, place - kEachRadius * place.normalized()}}};
}

// [MUL-3]
TEST(NeighbourCheck, TheMiddleOfTheGapIsTheBorderBetweenTwoRobots_MUL_3) {
  const navigation::Neighbours one = seenAt({1.0, 0.0});
  const navigation::NeighbourCheck check(one, Pose2(), kEach);
  EXPECT_TRUE(check.isOnOwnSide({0.38, 0.0, 0.0}));
  EXPECT_FALSE(check.isOnOwnSide({0.41, 0.0, 0.0}));
  EXPECT_TRUE(check.isOnOwnSide({0.38, 5.0, 0.0})) << "along the border the way is free";
  EXPECT_TRUE(check.isOnOwnSide({-5.0, 0.0, 0.0}));
}

// [MUL-3]
TEST(NeighbourCheck, WhoIsAtAnotherOneAlreadyMayLeaveAndComesNoNearer_MUL_3) {
  const navigation::Neighbours one = seenAt({0.15, 0.0});
  const navigation::NeighbourCheck check(one, Pose2(), kEach);
  EXPECT_TRUE(check.isOnOwnSide(Pose2()));
  EXPECT_TRUE(check.isOnOwnSide({-0.1, 0.0, 0.0}));
  EXPECT_TRUE(check.isOnOwnSide({0.0, 0.1, 0.0}));
  EXPECT_FALSE(check.isOnOwnSide({0.01, 0.0, 0.0}));
}

// [MUL-3]
TEST(NeighbourCheck, TheBorderWithALongFaceIsAlongTheFace_MUL_3) {
  const navigation::Neighbours box{{}, {{{Vec2(0.0, 0.5), Vec2::Zero(), 0.5}, Vec2(0.0, 0.3)}}};
  const navigation::NeighbourCheck check(box, Pose2(), kEach);
  EXPECT_TRUE(check.isOnOwnSide({0.5, 0.0, 0.0}));
  EXPECT_TRUE(check.isOnOwnSide({0.0, 0.08, 0.0}));
  EXPECT_FALSE(check.isOnOwnSide({0.0, 0.11, 0.0}));
}

// [MUL-3]
TEST(NeighbourCheck, ACornerThatSwingsOutDoesNotCrossTheBorder_MUL_3) {
  const Outline square = Outline::polygon({{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}});
  const navigation::Neighbours near = seenAt({0.45, 0.0});  // 0.15 m ahead of its front
  const navigation::NeighbourCheck check(near, Pose2(), square);
  EXPECT_TRUE(check.isOnOwnSide({0.01, 0.0, 0.0}));
  EXPECT_FALSE(check.isOnOwnSide({0.03, 0.0, 0.0})) << "the other one might turn as well";
  EXPECT_TRUE(check.isOnOwnSide({0.0, 0.0, 0.2}));
  EXPECT_FALSE(check.isOnOwnSide({0.0, 0.0, 0.25 * kPi})) << "a corner reaches 0.28 m ahead";
  EXPECT_TRUE(check.isOnOwnSide({0.0, 0.0, 0.5 * kPi}));
}

// [MUL-3]
TEST(NeighbourCheck, TheBorderWithOneThatOnlySpeaksIsNotAsked_MUL_3) {
  const navigation::Neighbours told{{{Vec2(1.0, 0.0), Vec2(0.5, 0.0), kEachRadius}}, {}};
  EXPECT_TRUE(navigation::NeighbourCheck(told, Pose2(), kEach).isOnOwnSide({0.6, 0.0, 0.0}))
      << "it may be behind a wall";
}

// [MUL-3]
TEST(NeighbourCheck, KeepsOffWhereOthersWillBeWhetherTheySayItOrAreSeen_MUL_3) {
  const navigation::Neighbours seen = seenAt({1.0, 1.0}, {0.0, -1.0});
  const navigation::Neighbours told{{seen.seen[0].body}, {}};
  for (const navigation::Neighbours& neighbours : {seen, told}) {
    const navigation::NeighbourCheck check(neighbours, Pose2(), kEach);
    EXPECT_TRUE(check.isFree({1.0, 0.0}, 0.1)) << "it is not there yet";
    EXPECT_FALSE(check.isFree({1.0, 0.0}, 1.0));
    EXPECT_TRUE(check.isFree({1.0, 0.0}, 3.0)) << "nobody knows what it will do by then";
  }
}

}  // namespace
}  // namespace frontier_pilot
