// What the avoider keeps free around robots of different sizes, and what it does with corners that a turn would swing
// into something.
#include <gtest/gtest.h>

#include <cmath>

#include "frontier_pilot/avoid/avoider.h"
#include "scan_maker.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

avoid::AvoiderParameters avoiderOf(const std::string& robot) {
  avoid::AvoiderParameters parameters;
  parameters.robot = test::shippedRobot(robot);
  return parameters;
}

// [ROB-1]
TEST(AvoiderDistances, AreForABurgerWhatTheyWereBeforeItsSizeWasKnown_ROB_1) {
  const avoid::AvoiderDistances burger(avoiderOf("burger"));
  EXPECT_EQ(burger.stop, 0.5);
  EXPECT_EQ(burger.clear, 0.65);
  EXPECT_EQ(burger.rear_stop, 0.25);
  EXPECT_EQ(burger.half_lane, 0.13);
  EXPECT_EQ(burger.turn, 0.0) << "a disc may always turn";
}

// [ROB-1]
TEST(AvoiderDistances, GrowWithTheRobot_ROB_1) {
  const avoid::AvoiderDistances waffle(avoiderOf("waffle"));
  EXPECT_NEAR(waffle.stop, 0.077 + 0.395, 1e-12);
  EXPECT_NEAR(waffle.clear, 0.077 + 0.545, 1e-12);
  EXPECT_NEAR(waffle.rear_stop, 0.205 + 0.145, 1e-12) << "its wheels are near its front";
  EXPECT_NEAR(waffle.half_lane, 0.153 + 0.025, 1e-12);
  EXPECT_NEAR(waffle.turn, std::hypot(0.205, 0.153) + 0.025, 1e-12);
  const avoid::AvoiderDistances turtlebot2(avoiderOf("turtlebot2"));
  EXPECT_NEAR(turtlebot2.stop, 0.177 + 0.395, 1e-12);
  EXPECT_NEAR(turtlebot2.rear_stop, 0.177 + 0.145, 1e-12);
  EXPECT_NEAR(turtlebot2.half_lane, 0.177 + 0.025, 1e-12);
}

TEST(AvoiderDistances, TheEndOfARecoveryFollowsTheDistanceThatStartsIt) {
  avoid::AvoiderParameters parameters = avoiderOf("burger");
  parameters.stop_distance = 0.7;
  EXPECT_EQ(avoid::AvoiderDistances(parameters).clear, 0.85);
  Problems problems;
  parameters.check(problems);
  EXPECT_TRUE(problems.empty());
}

// [ROB-1]
TEST(AvoiderDistances, AreTakenAsTheyAreWhereTheyAreGiven_ROB_1) {
  avoid::AvoiderParameters parameters = avoiderOf("waffle");
  EXPECT_TRUE(
      loadParameters(parseYaml("{stop_distance: 0.4, clear_distance: 0.7, rear_stop_distance: 0.3}"), parameters)
          .empty());
  const avoid::AvoiderDistances distances(parameters);
  EXPECT_EQ(distances.stop, 0.4);
  EXPECT_EQ(distances.clear, 0.7);
  EXPECT_EQ(distances.rear_stop, 0.3);
}

// [ROB-1]
TEST(AvoiderParameters, AreRefusedWhereTheyLieInsideTheRobotOrHaveAnOldName_ROB_1) {
  avoid::AvoiderParameters parameters;
  EXPECT_EQ(loadParameters(parseYaml("{stop_distance: 0.1, guard_half_width: 0.13}"), parameters),
            (Problems{"guard_half_width: is now a constant of the program and no longer a parameter",
                      "stop_distance: must be beyond the robot's front"}));
  EXPECT_EQ(loadParameters(parseYaml("robot: {outline: [], disc_radius: 0.0}"), parameters),
            (Problems{"robot/outline: must be given where disc_radius is 0"}))
      << "told once, and nothing is derived from it";
}

/// What such a robot commands at the first scan, in which there is a single point at each of the `points` in its frame.
avoid::AvoiderCommand firstCommand(const avoid::AvoiderParameters& parameters, const std::vector<Vec2>& points) {
  const Time now = timeFromSeconds(100.0);
  LaserScan2 scan = emptyScan({3600, 2.0 * kPi, false, {}}, now);
  for (const Vec2& point : points) putObstacle(scan, bearing(point), point.norm(), 0.0);
  avoid::Avoider avoider(parameters);
  avoider.onScan(scan, now);
  return avoider.tick(now).value();
}

/// A robot whose wheels are near its rear, which is wide for that.
avoid::AvoiderParameters steeredFarAhead() {
  avoid::AvoiderParameters parameters;
  parameters.robot.outline = {0.5, 0.25, -0.1, 0.25, -0.1, -0.25, 0.5, -0.25};
  parameters.robot.disc_radius = 0.0;
  return parameters;
}

// [AVO-4] [ROB-1]
TEST(AvoiderOfALongRobot, DoesNotBackUpIntoWhatStandsBehindARearCorner_AVO_4) {
  const Vec2 ahead(0.7, 0.1);
  EXPECT_LT(firstCommand(steeredFarAhead(), {ahead}).twist.linear, 0.0);
  EXPECT_LT(firstCommand(steeredFarAhead(), {ahead, {-0.25, 0.24}}).twist.linear, 0.0) << "0.15 m behind the corner";
  for (const double y : {-0.24, 0.0, 0.24}) {
    for (const double x : {-0.13, -0.24}) {
      EXPECT_GE(firstCommand(steeredFarAhead(), {ahead, {x, y}}).twist.linear, 0.0) << x << ", " << y << " [AVO-4]";
    }
  }
}

// [AVO-3] [ROB-1]
TEST(AvoiderOfAWideRobot, StopsForWhatIsAheadOfAFrontCornerAsForWhatIsAheadOfItsMiddle_AVO_3) {
  avoid::AvoiderParameters parameters;
  parameters.robot.outline = {0.1, 0.6, -0.1, 0.6, -0.1, -0.6, 0.1, -0.6};
  parameters.robot.disc_radius = 0.0;
  for (const double y : {-0.59, 0.0, 0.59}) {
    EXPECT_EQ(firstCommand(parameters, {{0.5, y}}), (avoid::AvoiderCommand{})) << y;
    for (const double x : {0.2, 0.36, 0.49}) {
      EXPECT_FALSE(firstCommand(parameters, {{x, y}}) == avoid::AvoiderCommand{}) << x << ", " << y << " [AVO-3]";
    }
  }
}

// [AVO-3] [AVO-4] [ROB-1]
TEST(AvoiderOfABurger, MeasuresFromTheMiddleOfItsDisc_AVO_3) {
  const avoid::AvoiderParameters burger = avoiderOf("burger");
  EXPECT_EQ(firstCommand(burger, {{0.49, 0.12}}), (avoid::AvoiderCommand{}));
  EXPECT_LT(firstCommand(burger, {{0.3, 0.0}, {-0.23, 0.12}}).twist.linear, 0.0);
  EXPECT_EQ(firstCommand(burger, {{0.3, 0.0}, {-0.22, 0.1}}).twist.linear, 0.0);
}

/// A Waffle with something ahead, and at times something beside its tail and behind it.
class WaffleAvoiderTest : public ::testing::Test {
 protected:
  avoid::AvoiderCommand tick() {
    now += std::chrono::milliseconds(100);
    LaserScan2 scan = emptyScan({}, now);
    putObstacle(scan, 0.3, 0.4);
    if (beside) putObstacle(scan, 1.9, 0.21, 0.0);  // 0.2 m to the left: past the side, within reach of a rear corner
    if (behind) putObstacle(scan, kPi, 0.34);
    avoider.onScan(scan, now);
    return avoider.tick(now).value_or(avoid::AvoiderCommand{{9.0, 9.0}, false});
  }

  avoid::Avoider avoider{avoiderOf("waffle")};
  Time now = timeFromSeconds(100.0);
  bool beside = false;
  bool behind = false;
};

// [AVO-3] [ROB-1]
TEST_F(WaffleAvoiderTest, TurnsWhereItsCornersAreFree_AVO_3) {
  for (int i = 0; i < 4; ++i) EXPECT_LT(tick().twist.linear, 0.0);
  EXPECT_LT(tick().twist.angular, 0.0) << "away from what is on its left";
}

// [AVO-3] [ROB-1]
TEST_F(WaffleAvoiderTest, BacksUpFurtherAsLongAsACornerWouldHitSomethingInATurn_AVO_3) {
  beside = true;
  for (int i = 0; i < 20; ++i) {
    const avoid::AvoiderCommand command = tick();
    EXPECT_LT(command.twist.linear, 0.0);
    EXPECT_EQ(command.twist.angular, 0.0);
  }
  beside = false;
  for (int i = 0; i < 4; ++i) tick();
  EXPECT_EQ(avoider.state(), avoid::AvoiderState::kRotate);
}

// [AVO-4] [AVO-6] [ROB-1]
TEST_F(WaffleAvoiderTest, HoldsWhereItCanNeitherTurnNorBackUp_AVO_4) {
  beside = behind = true;
  EXPECT_EQ(tick(), (avoid::AvoiderCommand{{0.0, 0.0}, true}));
  EXPECT_EQ(avoider.state(), avoid::AvoiderState::kStuck);
  EXPECT_EQ(avoider.status(now).reason, "obstacle ahead, and no room to turn or to back up");
}

// [AVO-3] [ROB-1]
TEST_F(WaffleAvoiderTest, StopsTurningWhenSomethingComesWithinReachOfItsCorners_AVO_3) {
  for (int i = 0; i < 6; ++i) tick();
  ASSERT_EQ(avoider.state(), avoid::AvoiderState::kRotate);
  beside = true;
  EXPECT_EQ(tick().twist.angular, 0.0);
}

}  // namespace
}  // namespace frontier_pilot
