#include "exploration/limits/way_inside.h"

#include "explorer_fixture.h"

namespace frontier_pilot {
namespace {

using test::ExplorerTest;
using State = exploration::ExplorerState;
using Reason = exploration::ExplorerReason;

/// A hall of 5 m x 3 m that is unknown at its right end; the robot is at the left.
class WayInside : public ExplorerTest {
 protected:
  explicit WayInside(const exploration::ExplorerParameters& parameters = shortSighted()) : ExplorerTest(parameters) {}
  static std::string hall() {
    std::string drawing = std::string(100, '#') + "\n";
    for (int row = 0; row < 58; ++row) {
      drawing +=
          "#" + std::string(9, '.') + (row == 29 ? "r" : ".") + std::string(79, '.') + std::string(10, '?') + "\n";
    }
    return drawing + std::string(100, '#') + "\n";
  }
  /// Across the middle of the hall; a gap is left at its upper wall.
  static exploration::ExplorationBounds barrier() {
    exploration::ExplorationBounds bounds;
    bounds.keep_out = {{{2.0, -1.0}, {3.0, -1.0}, {3.0, 2.2}, {2.0, 2.2}}};
    return bounds;
  }
  /// Whether the straight line touches the keep-out area of `barrier`.
  static bool crossesBarrier(const Vec2& from, const Vec2& to) {
    for (int i = 0; i <= 1000; ++i) {
      if (!barrier().contain(from + i / 1000.0 * (to - from))) return true;
    }
    return false;
  }
};

// [EXP-10]
TEST_F(WayInside, LeadsAroundAKeepOutAreaInStraightLegs_EXP_10) {
  show(hall());
  tick();
  ASSERT_TRUE(crossesBarrier(pose.position(), sent.goal.position())) << "without bounds it goes straight";
  explorer.setBounds(barrier(), world.map);
  int legs = 0;
  for (; tick().status.goals_reached == 0 && legs < 10; ++legs) {
    ASSERT_FALSE(crossesBarrier(pose.position(), sent.goal.position())) << "leg " << legs;
    pose = sent.goal;
    goalEnds(exploration::GoalEvent::Kind::kReached);
  }
  EXPECT_GT(pose.x, 3.5) << "stops on the way do not count as goals";
  EXPECT_GT(legs, 1);
  EXPECT_LE(legs, 4);
}

// [EXP-10]
TEST_F(WayInside, AGoalThatIsInSightIsSentAsItIs_EXP_10) {
  show(hall());
  tick();
  const Pose2 straight = sent.goal;
  exploration::ExplorationBounds bounds;
  bounds.keep_out = {{{2.0, -1.0}, {3.0, -1.0}, {3.0, 0.5}, {2.0, 0.5}}};
  explorer.setBounds(bounds, world.map);
  tickFor(3.0);
  EXPECT_EQ(sent.goal, straight);
}

// [EXP-10]
TEST_F(WayInside, AStopThatCannotBeReachedCountsAgainstTheGoalBehindIt_EXP_10) {
  show(hall());
  explorer.setBounds(barrier(), world.map);
  for (int i = 0; i < 2; ++i) {
    tickFor(0.3);
    goalEnds(exploration::GoalEvent::Kind::kAborted, "no path");
  }
  tick();
  EXPECT_EQ(notesWith("goal blacklisted: no path"), 1U);
}

// [EXP-10]
TEST_F(WayInside, AStopThatIsCalledReachedWhereTheRobotStandsIsNotSentForEver_EXP_10) {
  show(hall());
  explorer.setBounds(barrier(), world.map);
  for (int i = 0; i < 4 && notesWith("goal blacklisted") == 0; ++i) {
    tickFor(0.3);
    goalEnds(exploration::GoalEvent::Kind::kReached);  // by a navigation with a tolerance of metres
    tick();
  }
  EXPECT_EQ(notesWith("goal blacklisted: the navigation calls a stop on the way reached"), 1U);
}

// [EXP-10]
TEST_F(WayInside, ARobotThatLeavesTheBoundsOnItsWayIsStopped_EXP_10) {
  show(hall());
  exploration::ExplorationBounds bounds;
  bounds.stay_within = {{0.3, 0.5}, {4.9, 0.5}, {4.9, 2.5}, {0.3, 2.5}};
  explorer.setBounds(bounds, world.map);
  ASSERT_EQ(tick().status.state, State::kNavigating);
  pose.y = 0.4;
  const exploration::ExplorerOutput output = tick();
  EXPECT_EQ(output.command.kind, exploration::GoalCommand::Kind::kCancel);
  EXPECT_EQ(output.status.state, State::kSelectGoal);
  EXPECT_EQ(output.status.reason, exploration::ExplorerReason::kRobotOutOfBounds);
  tickFor(2.0);
  EXPECT_EQ(notesWith("outside of the bounds"), 1U);
  pose.y = 1.5;
  EXPECT_EQ(tickFor(0.5).status.state, State::kNavigating);
}

/// An exploration that ends at a fifth of the charge, with the robot on the other side of the barrier from its start.
class WayBack : public WayInside {
 protected:
  static exploration::ExplorerParameters returning() {
    exploration::ExplorerParameters parameters = shortSighted();
    parameters.until.battery = 0.2;
    parameters.return_to_start = true;
    return parameters;
  }
  explicit WayBack(const std::optional<Pose2>& from = std::nullopt) : WayInside(returning()) {
    show(hall());
    if (from) pose = *from;
    start = pose;
    explorer.setBounds(barrier(), world.map);
    inputs.battery = 0.5;
    tick();
    pose = Pose2(4.0, 1.5, 0.0);
    tick();
  }
  /// The battery's limit is reached.
  exploration::ExplorerOutput end() {
    inputs.battery = 0.2;
    return tick();
  }
  exploration::ExplorerOutput reachStop() {
    pose = sent.goal;
    goalEnds(exploration::GoalEvent::Kind::kReached);
    return tick();
  }
  void expectTheRestOfTheWay() {
    exploration::ExplorerOutput output;
    for (int leg = 0; leg < 10 && output.status.state != State::kDone; ++leg) {
      output = reachStop();
      const bool at_home = output.status.state == State::kDone;
      ASSERT_EQ(output.status.reason, at_home ? Reason::kUntilBattery : Reason::kReturningToStart);
    }
    EXPECT_EQ(output.status.reason, Reason::kUntilBattery);
    EXPECT_EQ(pose.position(), start.position());
  }

  Pose2 start;
};

// [EXP-10]
TEST_F(WayBack, GoesOnAtAStopAlthoughTheChargeHasRecovered_EXP_10) {
  ASSERT_EQ(end().status.reason, Reason::kReturningToStart);
  ASSERT_NE(sent.goal.position(), start.position()) << "it takes several legs";
  inputs.battery = 0.21;
  expectTheRestOfTheWay();
}

// [EXP-10]
TEST_F(WayBack, GoesOnAfterAGoalOfSomebodyElseAlthoughTheChargeIsUnknownByThen_EXP_10) {
  end();
  inputs.others_goal = true;
  ASSERT_EQ(tick().status.reason, Reason::kOthersGoal);
  inputs.others_goal = false;
  inputs.battery.reset();
  EXPECT_EQ(tick().status.reason, Reason::kReturningToStart);
  expectTheRestOfTheWay();
  change({90, 1, 9, 58}, kFree);
  EXPECT_EQ(tickFor(10.0).status.state, State::kDone);
}

// [EXP-10]
TEST_F(WayBack, IsFinishedAlthoughTheReturnIsSwitchedOffMeanwhile_EXP_10) {
  end();
  explorer.setReturnToStart(false);
  expectTheRestOfTheWay();
}

/// The same from a start that is too near to a wall for a way to lead to it.
class WayBackToAWall : public WayBack {
 protected:
  WayBackToAWall() : WayBack(Pose2(0.5, 0.12, 0.0)) {}
};

// [EXP-10]
TEST_F(WayBackToAWall, LeadsAroundAKeepOutAreaAsWell_EXP_10) {
  ASSERT_EQ(end().status.reason, Reason::kReturningToStart);
  exploration::ExplorerOutput output;
  for (int leg = 0; leg < 10 && output.status.state != State::kDone; ++leg) {
    ASSERT_FALSE(crossesBarrier(pose.position(), sent.goal.position())) << "leg " << leg;
    output = reachStop();
  }
  EXPECT_EQ(output.status.reason, Reason::kUntilBattery);
  EXPECT_EQ(pose.position(), start.position()) << "the start itself is the last leg";
}

// [EXP-10]
TEST_F(WayBack, IsNotTriedWithoutAKnownWayThatStaysWithinTheBounds_EXP_10) {
  change({1, 1, 30, 58}, kOccupied);
  const std::uint32_t before = history.back().goals_sent;
  const exploration::ExplorerOutput output = end();
  EXPECT_EQ(output.status.state, State::kDone);
  EXPECT_EQ(output.status.reason, Reason::kUntilBattery);
  EXPECT_EQ(output.status.goals_sent, before);
  EXPECT_EQ(notesWith("does not return to the start"), 1U);
}

/// Two halls of free floor that a keep-out area across the whole building separates.
class SeparatedByBounds : public WayInside {
 protected:
  static exploration::ExplorationBounds across() {
    exploration::ExplorationBounds bounds;
    bounds.keep_out = {{{2.0, -1.0}, {2.5, -1.0}, {2.5, 4.0}, {2.0, 4.0}}};
    return bounds;
  }
};

// [EXP-10]
TEST_F(SeparatedByBounds, TheWaysFromTheStartAreNotTriedAcross_EXP_10) {
  std::string drawing = hall();
  std::reverse(drawing.begin(), drawing.end() - 1);  // unknown at the left end, where the robot will not be
  show(drawing);
  pose = Pose2(1.5, 1.5, 0.0);  // the start, beside the unknown end
  tick();                       // it begins there
  inputs.enabled = false;
  tick();
  const std::uint32_t before = history.back().goals_sent;
  pose = Pose2(4.0, 1.5, 0.0);
  explorer.setBounds(across(), world.map);
  inputs.enabled = true;
  EXPECT_EQ(tickFor(5.0).status.state, State::kDone);
  EXPECT_EQ(history.back().goals_sent, before);
}

/// A floor that is bounded, and the ways over it from where the robot stands.
struct BoundedFloor {
  BoundedFloor(const OccupancyGrid& floor, const exploration::ExplorationBounds& bounds, const Vec2& robot) {
    map.setBounds(bounds);
    map.update(floor, floor.geometry().rect());
    exploration::TraversableSpace space(0.134);
    space.update(map.grid(), map.geometry().rect());
    travel.compute(space, map.grid(), map.geometry().cellAt(robot), 0.6);
  }

  exploration::ObservedMap map;
  exploration::TravelField travel;
};

// [EXP-10]
TEST_F(WayInside, ALaneBesideTheBoundsLeavesTheRobotItsMargin_EXP_10) {
  const test::AsciiWorld room = test::drawWorld(hall());
  exploration::ExplorationBounds bounds;
  bounds.keep_out = {{{2.0, 1.62}, {3.0, 1.62}, {3.0, 2.8}, {2.0, 2.8}}};  // less than 0.134 m beside the line
  const Vec2 robot(1.0, 1.5), goal(4.0, 1.5);
  const BoundedFloor floor(room.map, bounds, robot);
  const Vec2 stop = exploration::stopOnTheWay(floor.travel, floor.map, robot, goal, floor.map.geometry().cellAt(goal),
                                              {0.134, 0.089});
  EXPECT_NE(stop, goal);
  EXPECT_GT((stop - robot).norm(), 0.5);
}

/// A hall with baffles, so that the way through it is long, and a straight passage beside it. 4 m x 2.5 m.
std::string baffles() {
  std::vector<std::string> rows(50, "#" + std::string(78, '.') + "#");
  rows.front() = rows.back() = std::string(80, '#');
  for (int row = 18; row < 28; ++row) rows[static_cast<std::size_t>(row)].replace(15, 50, 50, '#');
  for (int baffle = 0; baffle < 5; ++baffle) {
    const int top = baffle % 2 == 0 ? 28 : 35;
    for (int row = top; row < top + 15 && row < 50; ++row) {
      rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(20 + 10 * baffle)] = '#';
    }
  }
  std::string drawing;
  for (const std::string& row : rows) drawing += row + "\n";
  return drawing;
}

// [EXP-10]
TEST(StopOnTheWay, LeavesTheNavigationNoShorterWayThroughWhatIsOutOfBounds_EXP_10) {
  const test::AsciiWorld world = test::drawWorld(baffles());
  exploration::ExplorationBounds bounds;
  bounds.keep_out = {{{1.5, 1.65}, {2.5, 1.65}, {2.5, 2.5}, {1.5, 2.5}}};  // in the passage
  const Vec2 robot(0.5, 0.6), goal(3.5, 0.6);
  const BoundedFloor floor(world.map, bounds, robot);
  ASSERT_TRUE(floor.travel.reached(floor.map.geometry().cellAt(goal)));
  const Vec2 stop = exploration::stopOnTheWay(floor.travel, floor.map, robot, goal, floor.map.geometry().cellAt(goal),
                                              {0.134, 0.089});
  EXPECT_NE(stop, goal) << "the passage is shorter than the way between the baffles";
}

}  // namespace
}  // namespace frontier_pilot
