#include "support/explore_options.h"

#include <cmath>
#include <stdexcept>

#include "frontier_pilot/sim/simulator.h"
#include "support/fleet_starts.h"
#include "support/named_limits.h"
#include "support/named_robot.h"
#include "tools/arguments.h"

namespace frontier_pilot::bench {
namespace {

/// The clearance on either side of the robot with which floor still counts as reachable [m].
constexpr double kRoomBeside = 0.045;

void readOff(tools::Arguments& arguments, ExploreOptions& o) {
  o.off_from = arguments.number();
  const double until = arguments.number();
  if (until > o.off_from) o.off_until = until;
}

Pose2 poseOf(tools::Arguments& arguments) {
  const double x = arguments.number();
  const double y = arguments.number();
  return {x, y, arguments.number()};
}

void takeWord(const std::string& word, tools::Arguments& arguments, ExploreOptions& o) {
  if (word == "--seeds") return void(o.seeds = arguments.range());
  if (word == "--robots") return void(o.robots = static_cast<int>(arguments.number()));
  if (word == "--robot") return void(o.robot = arguments.text());
  if (word == "--limits") return void(o.limits = arguments.text());
  if (word == "--strategy") return void(o.strategy = arguments.text());
  if (word == "--start") return void(o.start = poseOf(arguments));
  if (word == "--until") return void(o.until = arguments.number());
  if (word == "--limit") return void(o.limit = arguments.number());
  if (word == "--off") return readOff(arguments, o);
  if (word == "--latency") return void(o.latency = arguments.number());
  if (word == "--at-once") return void(o.at_once = true);
  if (word == "--skewed") return void(o.skewed = true);
  if (word == "--odom-noise") return void(o.odom_noise = true);
  if (word == "--curve") return void(o.curve = true);
  if (word == "--driving") return void(o.driving = true);
  if (word == "--decisions") return void(o.decisions = true);
  if (word == "--no-agreement") return void(o.no_agreement = true);
  if (word == "--no-rule") return void(o.no_rule = true);
  if (word == "--log") return void(o.log = true);
  if (word == "--twice") return void(o.twice = true);
  if (word == "--omniscient") return void(o.omniscient = true);
  if (word == "--svg") return void(o.svg = arguments.text());
  if (tools::Arguments::isOption(word)) throw std::invalid_argument("unknown option " + word);
  o.worlds.push_back(word);
}

}  // namespace

ExploreOptions parseExploreOptions(const std::vector<std::string>& words) {
  tools::Arguments arguments(words);
  ExploreOptions options;
  while (!arguments.atEnd()) {
    const std::string word = arguments.next();
    takeWord(word, arguments, options);
  }
  if (options.latency < 0.0) throw std::invalid_argument("--latency must not be negative");
  if (options.robots < 1 || options.robots > 100) throw std::invalid_argument("--robots must be 1 to 100");
  if (options.robots == 1 && std::isfinite(options.off_from)) throw std::invalid_argument("--off takes several robots");
  if (options.robots > 1 && options.driving) throw std::invalid_argument("--driving takes one robot");
  if (options.worlds.empty()) throw std::invalid_argument("no world given");
  return options;
}

RobotModel robotOf(const ExploreOptions& options) {
  RobotModel robot = robotNamed(options.robot);
  if (!options.limits.empty()) robot.limits = limitsNamed(options.limits);
  if (options.at_once) robot.scanner.rolling = false;
  if (options.skewed) robot.scanner.time_increment = 0.0;
  return robot;
}

system::ClosedLoopParameters parametersFor(const ExploreOptions& options, const std::string& world, int seed) {
  system::ClosedLoopParameters parameters;
  parameters.setRobot(robotOf(options));
  parameters.simulator.world = world;
  parameters.simulator.seed = seed;
  parameters.simulator.odom_noise = options.odom_noise;
  parameters.mapper.trust_odometry = !options.odom_noise;
  // What is seen from the start anchors the map: the mapper observes it for a while before the robot leaves.
  constexpr double kLook = 2.0;  // [s]
  if (options.odom_noise) parameters.head_start = kLook;
  parameters.explorer.strategy = options.strategy;
  parameters.agree = !options.no_agreement;
  parameters.give_way = !options.no_rule;
  parameters.latency = options.latency;
  if (options.start) {
    parameters.simulator.x = options.start->x;
    parameters.simulator.y = options.start->y;
    parameters.simulator.yaw = options.start->yaw;
  }
  if (options.robots > 1) {
    const sim::Simulator alone(sim::loadWorld(world), parameters.simulator);
    const double radius = parameters.simulator.robot.drivenOutline().circumscribedRadius();
    parameters.simulator.robots =
        fleetStarts(alone.map(), alone.startPose(0), static_cast<std::size_t>(options.robots), radius, seed);
  }
  return parameters;
}

double floorRadius(const RobotModel& robot) { return robot.drivenOutline().halfWidth() + kRoomBeside; }

}  // namespace frontier_pilot::bench
