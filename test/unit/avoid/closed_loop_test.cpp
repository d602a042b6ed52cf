// A driver that only knows "forward, full speed" in a cluttered world, with nothing but avoider and arbiter to save
// him. FRONTIER_PILOT_SEEDS and FRONTIER_PILOT_SECONDS ask for more than the handful of minutes that every run does.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "frontier_pilot/arbiter/arbiter.h"
#include "frontier_pilot/avoid/avoider.h"
#include "frontier_pilot/sim/simulator.h"
#include "support/shipped_robot.h"

namespace frontier_pilot {
namespace {

constexpr double kSide = 12.0;  // [m]
constexpr double kCell = 0.05;  // [m]

int fromEnvironment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::atoi(text) : otherwise;
}

/// A room full of pillars, posts of one cell and slanting walls; free around its centre.
OccupancyGrid clutteredRoom(std::uint32_t seed) {
  const int cells = static_cast<int>(kSide / kCell);
  OccupancyGrid room({kCell, Vec2::Zero(), cells, cells}, kFree);
  const auto fill = [&](const Vec2& point) {
    const Cell cell = room.geometry().cellAt(point);
    if (room.contains(cell) && (point - Vec2(kSide / 2.0, kSide / 2.0)).norm() > 0.6) room[cell] = kOccupied;
  };
  for (double s = 0.0; s < kSide; s += kCell) {
    for (const Vec2& point : {Vec2(s, 0.0), Vec2(s, kSide - 0.01), Vec2(0.0, s), Vec2(kSide - 0.01, s)}) fill(point);
  }
  std::mt19937 dice(seed);
  std::uniform_real_distribution<double> anywhere(0.0, kSide), size(0.0, 0.3), angle(0.0, kPi);
  for (int i = 0; i < 14; ++i) {
    const Vec2 post(anywhere(dice), anywhere(dice)), pillar(anywhere(dice), anywhere(dice));
    const Vec2 wall(anywhere(dice), anywhere(dice)), along = direction(angle(dice));
    const double radius = size(dice);
    fill(post);
    for (double x = -radius; x <= radius; x += kCell) {
      for (double y = -radius; y <= radius; y += kCell) fill(pillar + Vec2(x, y));
    }
    for (double s = 0.0; s < 1.2; s += kCell / 2.0) fill(wall + s * along);
  }
  return room;
}

/// Simulator, avoider and arbiter in lockstep, and the driver.
class BlindDrive {
 public:
  BlindDrive(std::uint32_t seed, const RobotModel& robot)
      : simulator_({clutteredRoom(seed), std::nullopt}, simulation(seed, robot)),
        arbiter_(arbitration(robot)),
        avoider_(avoidance(robot)),
        placer_(robot.scanner),
        forward_{robot.limits.max_linear, 0.0} {}

  void drive(int seconds) {
    for (int step = 1; step <= seconds * 100; ++step) {
      simulator_.step();
      placer_.addOdometry(simulator_.now(), simulator_.odometry(0));
      if (const LaserScan2* scan = simulator_.newScan(0)) {
        LaserScan2 placed = *scan;
        placer_.place(ScanReference::kEnd, placed);
        avoid(avoider_.onScan(placed, simulator_.now()));
      }
      if (step % 10 == 0) tick();
      const Vec2 position = simulator_.pose(0).position();
      distance_ += (position - last_).norm();
      last_ = position;
    }
  }
  int contacts() const { return simulator_.contactCount(0); }
  double distance() const { return distance_; }
  avoid::AvoiderSnapshot avoider() const { return avoider_.status(simulator_.now()); }

 private:
  static sim::SimulatorParameters simulation(std::uint32_t seed, const RobotModel& robot) {
    sim::SimulatorParameters parameters;
    parameters.x = parameters.y = kSide / 2.0;
    parameters.yaw = seed;
    parameters.seed = static_cast<int>(seed);
    parameters.robot = robot;
    parameters.lidar.dropout = 0.02;
    return parameters;
  }
  static arbiter::ArbiterParameters arbitration(const RobotModel& robot) {
    arbiter::ArbiterParameters parameters;
    parameters.robot = robot;
    parameters.sources[0].required = true;
    return parameters;
  }
  static avoid::AvoiderParameters avoidance(const RobotModel& robot) {
    avoid::AvoiderParameters parameters;
    parameters.robot = robot;
    return parameters;
  }
  Instant now() const { return {simulator_.now(), SteadyTime(simulator_.now().time_since_epoch())}; }

  void avoid(const std::optional<avoid::AvoiderCommand>& command) {
    if (command) publish(arbiter_.onCommand(0, command->twist, now(), command->hold));
  }
  void tick() {
    avoid(avoider_.tick(simulator_.now()));
    publish(arbiter_.onCommand(4, forward_, now()));
    publish(arbiter_.tick(now()));
  }
  void publish(const std::optional<Twist2>& twist) {
    if (twist) simulator_.setCommand(0, *twist);
  }

  sim::Simulator simulator_;
  arbiter::Arbiter arbiter_;
  avoid::Avoider avoider_;
  ScanPlacer placer_;
  Twist2 forward_;
  Vec2 last_{kSide / 2.0, kSide / 2.0};
  double distance_ = 0.0;
};

void driveBlindly(const RobotModel& robot) {
  const int seeds = fromEnvironment("FRONTIER_PILOT_SEEDS", 4);
  const int seconds = fromEnvironment("FRONTIER_PILOT_SECONDS", 300);
  double distance = 0.0;
  unsigned episodes = 0;
  int stuck = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    BlindDrive drive(static_cast<std::uint32_t>(seed), robot);
    drive.drive(seconds);
    EXPECT_EQ(drive.contacts(), 0) << "seed " << seed << " [AVO-3]";
    distance += drive.distance();
    episodes += drive.avoider().episodes;
    stuck += drive.avoider().state == avoid::AvoiderState::kStuck ? 1 : 0;
  }
  std::printf("%d seeds of %d s: %.0f m, %u recoveries, %d ended stuck\n", seeds, seconds, distance, episodes, stuck);
  EXPECT_GT(distance, 0.1 * robot.limits.max_linear * seeds * seconds) << "it must not be safe by standing";
}

/// A Burger with a scanner that looks by half of `angle` [rad] to either side, with a beam for each degree.
RobotModel withFieldOfView(double angle) {
  RobotModel robot = test::shippedRobot("burger");
  robot.scanner.field_of_view = angle;
  robot.scanner.angle_min = -angle / 2.0;
  robot.scanner.beams = static_cast<int>(std::lround(angle * 180.0 / kPi)) + 1;
  return robot;
}

// [AVO-3] [AVO-4]
TEST(BlindDrive, TouchesNothingAtTheBurgersFullSpeed_AVO_3) { driveBlindly(test::shippedRobot("burger")); }

// [AVO-3] [AVO-4]
TEST(BlindDrive, TouchesNothingAtTheFastBasesFullSpeed_AVO_3) { driveBlindly(test::shippedRobot("fast")); }

// [AVO-3] [AVO-4] [ROB-1]
TEST(BlindDrive, TouchesNothingWithTheCornersOfAWaffle_AVO_3) { driveBlindly(test::shippedRobot("waffle")); }

// [AVO-3] [AVO-4] [ROB-1]
TEST(BlindDrive, TouchesNothingAtTheFullSpeedOfATurtleBot2_AVO_3) { driveBlindly(test::shippedRobot("turtlebot2")); }

// [AVO-3] [AVO-4]
TEST(BlindDrive, TouchesNothingAndGetsOutByTurningWithAScannerThatDoesNotLookBack_AVO_4) {
  driveBlindly(withFieldOfView(kPi));
}

// [AVO-3] [AVO-4]
TEST(BlindDrive, TouchesNothingWithAScannerThatSeesOnlyTheEdgesOfWhatIsBehind_AVO_4) {
  driveBlindly(withFieldOfView(1.5 * kPi));
}

}  // namespace
}  // namespace frontier_pilot
