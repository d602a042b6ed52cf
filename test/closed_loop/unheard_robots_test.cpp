#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "frontier_pilot/sim/simulator.h"
#include "sim/random.h"
#include "support/closed_loop/driven_fleet.h"
#include "support/shipped_robot.h"

namespace frontier_pilot::test {
namespace {

constexpr double kReach = 5.0;  // [m], of the places that they drive to

/// Three robots that cross each other's ways in a part of the office: whoever arrives is sent to another place.
class CrossingRobots {
 public:
  CrossingRobots(int seed, bool rule)
      : world_(sim::loadWorld(std::string(WORLDS_DIRECTORY) + "/office.yaml")),
        random_(static_cast<std::uint64_t>(seed)),
        starts_(drawStarts()),
        fleet_(world_.map, starts_, turtleBot2(), rule) {}

  DrivenFleet& fleet() { return fleet_; }
  int goals() const { return goals_; }

  void step() {
    for (std::size_t i = 0; i < starts_.size(); ++i) {
      if (!fleet_.arrived(i)) continue;
      fleet_.send(i, placeWithin(kReach, starts_[0].position()));
      ++goals_;
    }
    fleet_.step();
  }

  /// What one of them might have said at some time, as somebody else would say it again.
  fleet::MotionMessage drawLie() {
    fleet::MotionMessage lie;
    const auto robot = static_cast<std::size_t>(3.0 * random_.uniform());
    if (const auto told = fleet_.told(robot)) lie = *told;
    lie.robot = "robot" + std::to_string(robot + 1);
    if (random_.uniform() < 0.5) lie.position += Vec2(6.0 * random_.uniform() - 3.0, 6.0 * random_.uniform() - 3.0);
    if (random_.uniform() < 0.2) lie.path.clear();
    if (random_.uniform() < 0.2) std::swap(lie.yields_to, lie.passes);
    if (random_.uniform() < 0.2) lie.cannot_yield = !lie.cannot_yield;
    lie.radius = 0.2;
    return lie;
  }

 private:
  static navigation::NavigatorParams turtleBot2() {
    navigation::NavigatorParams params;
    params.robot = shippedRobot("turtlebot2");
    return params;
  }

  Vec2 placeWithin(double reach, const Vec2& centre) {
    const GridGeometry& grid = world_.map.geometry();
    while (true) {
      const Cell cell{static_cast<int>(random_.uniform() * grid.width),
                      static_cast<int>(random_.uniform() * grid.height)};
      if ((grid.centre(cell) - centre).norm() < reach && hasRoom(cell)) return grid.centre(cell);
    }
  }

  bool hasRoom(Cell middle) const {
    constexpr int kRoom = 8;  // [cells]
    for (int y = -kRoom; y <= kRoom; ++y) {
      for (int x = -kRoom; x <= kRoom; ++x) {
        if (!isFree(world_.map.get({middle.x + x, middle.y + y}, kOccupied))) return false;
      }
    }
    return true;
  }

  std::vector<Pose2> drawStarts() {
    std::vector<Pose2> starts{{placeWithin(100.0, Vec2::Zero()), 0.0}};
    while (starts.size() < 3) {
      const Vec2 place = placeWithin(4.0, starts[0].position());
      const auto is_near = [&](const Pose2& start) { return (start.position() - place).norm() < 1.0; };
      if (std::none_of(starts.begin(), starts.end(), is_near)) starts.emplace_back(place, 0.0);
    }
    return starts;
  }

  sim::World world_;
  sim::Random random_;
  std::vector<Pose2> starts_;
  DrivenFleet fleet_;
  int goals_ = 0;
};

// [MUL-3]
TEST(UnheardRobots, DoNotTouchEachOtherInTheOpenByWhatTheyScan_MUL_3) {
  for (const int seed : {1, 2, 3}) {
    CrossingRobots robots(seed, false);
    while (toSeconds(robots.fleet().now()) < 100.0) robots.step();
    EXPECT_EQ(robots.fleet().contacts(), 0) << "seed " << seed;
    EXPECT_GT(robots.goals(), 12) << "they drive, seed " << seed;
  }
}

// [MUL-3] [FLT-1] A hundred times a second somebody says something else under one of their names.
TEST(UnheardRobots, DoNotTouchEachOtherWhateverIsSaidUnderTheirNames_MUL_3_FLT_1) {
  for (const int seed : {1, 4}) {
    CrossingRobots robots(seed, true);
    while (toSeconds(robots.fleet().now()) < 100.0) {
      robots.step();
      robots.fleet().hear(robots.drawLie());
    }
    EXPECT_EQ(robots.fleet().contacts(), 0) << "seed " << seed;
    EXPECT_GT(robots.goals(), 8) << "they drive, seed " << seed;
  }
}

}  // namespace
}  // namespace frontier_pilot::test
