#include "frontier_pilot/fleet/traffic.h"

#include <gtest/gtest.h>

#include <limits>

#include "frontier_pilot/core/grid.h"

namespace frontier_pilot::fleet {
namespace {

constexpr double kRadius = 0.15;  // [m]

/// Two rooms of 3 m x 3 m and a corridor of 6 m x 0.7 m between them, from x = 3 to 9 at y = 1.5.
OccupancyGrid building() {
  OccupancyGrid map(GridGeometry{0.05, Vec2::Zero(), 240, 60}, kOccupied);
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Vec2 at = map.geometry().centre(map.geometry().cell(i));
    const bool inside = at.x() > 0.1 && at.x() < 11.9 && at.y() > 0.1 && at.y() < 2.9;
    if (inside && (at.x() < 3.0 || at.x() > 9.0 || std::abs(at.y() - 1.5) < 0.35)) map[i] = kFree;
  }
  return map;
}

/// A robot that follows the rule, in a frame that it has in common with the others, by a time that the test drives.
struct Robot {
  Robot(const std::string& name, const Vec2& start, const std::optional<Vec2>& target)
      : rule(name, kRadius), position(start), goal(target) {}

  TrafficOrder update(const OccupancyGrid& map, double t) {
    TrafficInputs inputs;
    inputs.T_map_base = Pose2(position, 0.0);
    inputs.goal = goal;
    if (goal) inputs.path = {position, Vec2(position.x(), 1.5), Vec2(goal->x(), 1.5), *goal};
    inputs.map = &map;
    inputs.T_map_common = Pose2();
    return order = rule.update(inputs, timeFromSeconds(t));
  }

  TrafficRule rule;
  Vec2 position;
  std::optional<Vec2> goal;
  TrafficOrder order;
};

/// Both decide and tell each other, twice a second from `from` to `to` [s].
void talk(Robot& a, Robot& b, double from, double to) {
  const OccupancyGrid map = building();
  for (double t = from; t <= to; t += 0.5) {
    a.update(map, t);
    b.update(map, t);
    if (const auto message = a.rule.message()) b.rule.hear(*message, timeFromSeconds(t));
    if (const auto message = b.rule.message()) a.rule.hear(*message, timeFromSeconds(t));
  }
}

using Kind = TrafficOrder::Kind;

// [MUL-3]
TEST(TrafficRule, WhoIsNearerToTheWayOutGoesAndTheOtherGetsOutOfTheWay_MUL_3) {
  Robot a("a", {4.0, 1.5}, Vec2(10.5, 1.5));  // has 5 m to go in the corridor
  Robot b("b", {6.0, 1.5}, Vec2(1.0, 1.5));   // has 3 m
  talk(a, b, 0.0, 2.0);
  EXPECT_EQ(b.order.kind, Kind::kFree);
  ASSERT_EQ(a.order.kind, Kind::kAside);
  EXPECT_LT(a.order.place.x(), 3.0) << "the way that it came";
  EXPECT_GT(std::abs(a.order.place.y() - 1.5), 2.0 * kRadius);
  EXPECT_EQ(a.order.text(), "makes way for b");
  ASSERT_EQ(b.order.making_way.size(), 1U);
}

// [MUL-3] Where a robot was that makes way is no free ground once it is elsewhere.
TEST(TrafficRule, ARobotThatGetsOutOfTheWayKnowsOnlyWhereTheOthersThatMakeWayAreNow_MUL_3) {
  Robot a("a", {4.0, 1.5}, Vec2(10.5, 1.5));  // has 5 m to go in the corridor
  Robot b("b", {6.0, 1.5}, Vec2(1.0, 1.5));   // has 3 m
  Robot c("c", {8.5, 1.5}, Vec2(1.0, 1.5));   // has more than a
  for (int i = 0; i < 10; ++i) {
    talk(a, b, 0.5 * i, 0.5 * i);
    talk(a, c, 0.5 * i, 0.5 * i);
  }
  ASSERT_EQ(a.order.kind, Kind::kAside);
  EXPECT_EQ(a.order.making_way.size(), 1U);
}

// [MUL-3]
TEST(TrafficRule, OfEqualsTheOneWhoseNameComesFirstGoes_MUL_3) {
  Robot a("a", {2.0, 0.5}, Vec2(10.5, 1.5));
  Robot b("b", {10.0, 0.5}, Vec2(1.0, 1.5));
  talk(a, b, 0.0, 2.0);
  EXPECT_EQ(a.rule.message()->passes, std::vector<std::string>{"b"});
  EXPECT_EQ(b.rule.message()->yields_to, std::vector<std::string>{"a"});
}

// [MUL-3]
TEST(TrafficRule, ARobotThatIsOutOfTheWayWaitsBeforeTheCorridorAndGoesOnWhenTheOtherIsThrough_MUL_3) {
  Robot a("a", {2.85, 1.0}, Vec2(10.5, 1.5));
  Robot b("b", {6.0, 1.5}, Vec2(1.0, 2.4));
  talk(a, b, 0.0, 2.0);
  EXPECT_EQ(a.order.kind, Kind::kHold);
  EXPECT_EQ(a.order.text(), "waits for b");
  for (double t = 2.0; t < 8.0; t += 0.5) {
    b.position.x() -= 0.4;
    talk(a, b, t, t);
  }
  EXPECT_EQ(a.order.kind, Kind::kFree);
}

// [MUL-3]
TEST(TrafficRule, StaysAsItIsOnceBothHaveSaidIt_MUL_3) {
  Robot a("a", {4.0, 1.5}, Vec2(10.5, 1.5));
  Robot b("b", {6.0, 1.5}, Vec2(1.0, 1.5));
  talk(a, b, 0.0, 1.0);
  a.position.x() = 5.5;  // now it would be the nearer one
  b.position.x() = 8.0;
  talk(a, b, 1.5, 3.0);
  EXPECT_EQ(a.rule.message()->yields_to, std::vector<std::string>{"b"});
}

// [MUL-3]
TEST(TrafficRule, ARobotThatFallsSilentIsNoLongerWaitedFor_MUL_3) {
  Robot a("a", {2.85, 1.0}, Vec2(10.5, 1.5));
  Robot b("b", {6.0, 1.5}, Vec2(1.0, 2.4));
  talk(a, b, 0.0, 2.0);
  ASSERT_EQ(a.order.kind, Kind::kHold);
  const OccupancyGrid map = building();
  EXPECT_EQ(a.update(map, 3.5).kind, Kind::kHold);
  EXPECT_EQ(a.update(map, 4.6).kind, Kind::kFree);
}

// [MUL-3]
TEST(TrafficRule, ARobotThatShouldGoAndStandsIsWaitedForNoLongerThanAQuarterOfAMinute_MUL_3) {
  Robot a("a", {2.85, 1.0}, Vec2(10.5, 1.5));
  Robot b("b", {6.0, 1.5}, Vec2(1.0, 2.4));
  talk(a, b, 0.0, 12.0);
  EXPECT_EQ(a.order.kind, Kind::kHold);
  talk(a, b, 12.5, 18.0);
  EXPECT_EQ(a.order.kind, Kind::kFree);
}

// [MUL-3]
TEST(TrafficRule, ARobotWithoutAGoalDoesNotMoveByItselfAndIsNotWaitedFor_MUL_3) {
  Robot a("a", {5.0, 1.5}, std::nullopt);
  Robot b("b", {8.0, 1.5}, Vec2(1.0, 1.5));
  talk(a, b, 0.0, 6.0);
  EXPECT_EQ(a.order.kind, Kind::kFree);
  EXPECT_EQ(b.order.kind, Kind::kFree) << "it is an obstacle like any other";
  EXPECT_TRUE(b.order.making_way.empty());
}

// [MUL-3]
TEST(TrafficRule, InARoomNobodyGivesWay_MUL_3) {
  Robot a("a", {0.5, 1.5}, Vec2(2.5, 1.5));
  Robot b("b", {2.5, 1.5}, Vec2(0.5, 1.5));
  talk(a, b, 0.0, 2.0);
  EXPECT_EQ(a.order.kind, Kind::kFree);
  EXPECT_EQ(b.order.kind, Kind::kFree);
}

// [MUL-3] [FLT-1]
TEST(TrafficRule, RefusesOtherVersionsAndNumbersThatMakeNoSense_MUL_3_FLT_1) {
  TrafficRule rule("a", kRadius);
  MotionMessage good;
  good.robot = "b";
  good.radius = kRadius;
  EXPECT_EQ(rule.hear(good, Time{}), ClaimsVerdict::kTaken);
  MotionMessage bad = good;
  bad.version = 2;
  EXPECT_EQ(rule.hear(bad, Time{}), ClaimsVerdict::kOtherVersion);
  bad = good;
  bad.path.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0.0);
  EXPECT_EQ(rule.hear(bad, Time{}), ClaimsVerdict::kMalformed);
  bad = good;
  bad.path.resize(MotionMessage::kMostPoints + 1, Vec2::Zero());
  EXPECT_EQ(rule.hear(bad, Time{}), ClaimsVerdict::kTooMany);
  bad = good;
  bad.robot = "a";
  EXPECT_EQ(rule.hear(bad, Time{}), ClaimsVerdict::kOwn);
}

// [MUL-3]
TEST(TrafficRule, SaysNothingWhileItsPlaceAmongTheOthersIsNotKnown_MUL_3) {
  TrafficRule rule("a", kRadius);
  const OccupancyGrid map = building();
  TrafficInputs inputs;
  inputs.map = &map;
  EXPECT_EQ(rule.update(inputs, Time{}).kind, Kind::kFree);
  EXPECT_FALSE(rule.message().has_value());
}

// [MUL-3]
TEST(TrafficRule, TellsWhereTheOthersThatDriveAreByNow_MUL_3) {
  const OccupancyGrid map = building();
  Robot robot("a", {1.0, 1.5}, Vec2(2.0, 1.5));
  MotionMessage other;
  other.robot = "b";
  other.radius = kRadius;
  const auto hear = [&](const Vec2& position, double t) {
    other.position = position;
    EXPECT_EQ(robot.rule.hear(other, timeFromSeconds(t)), ClaimsVerdict::kTaken);
    return robot.update(map, t + 0.2).moving;
  };
  EXPECT_TRUE(hear({2.0, 1.0}, 1.0).empty()) << "it may stand";
  const auto moving = hear({2.0, 1.2}, 1.5);
  ASSERT_EQ(moving.size(), 1U);
  EXPECT_LT((moving[0].velocity - Vec2(0.0, 0.4)).norm(), 1e-9);
  EXPECT_LT((moving[0].centre - Vec2(2.0, 1.28)).norm(), 1e-9);
  EXPECT_EQ(moving[0].radius, kRadius);
  EXPECT_TRUE(hear({2.0, 1.2}, 2.0).empty()) << "it stands";
  EXPECT_TRUE(hear({5.0, 1.2}, 2.5).empty()) << "its place was corrected";
}

}  // namespace
}  // namespace frontier_pilot::fleet
