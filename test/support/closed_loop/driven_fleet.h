#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/fleet/traffic.h"
#include "frontier_pilot/navigation/navigator.h"
#include "frontier_pilot/sim/simulator.h"
#include "support/closed_loop/standing_watch.h"

namespace frontier_pilot::test {

/// Robots on a known map, each with a navigator that is sent its goal again whenever it gives up, connected as the
/// nodes are: 10 cycles a second, two messages a second to the others.
class DrivenFleet {
 public:
  /// `rule`: whether they agree who goes first. [MUL-3]
  DrivenFleet(const OccupancyGrid& map, const std::vector<Pose2>& starts, const navigation::NavigatorParams& params,
              bool rule = true);

  void send(std::size_t robot, const Vec2& goal);
  /// A robot that is off neither drives nor says anything.
  void setPowered(std::size_t robot, bool on) { robots_[robot]->powered = on; }
  /// All robots hear a message that may be anyone's.
  void hear(const fleet::MotionMessage& message);
  /// What a robot told the others last; nothing before it has spoken.
  std::optional<fleet::MotionMessage> told(std::size_t robot) const { return robots_[robot]->rule.message(); }
  void step();
  /// Steps until all have arrived, or for `seconds`; returns whether they have.
  bool run(double seconds);

  Time now() const { return simulator_.now(); }
  bool arrived(std::size_t robot) const { return !robots_[robot]->goal; }
  const Pose2& pose(std::size_t robot) const { return simulator_.pose(robot); }
  const navigation::NavigatorOutput& output(std::size_t robot) const { return robots_[robot]->output; }
  int contacts() const;
  int given_up() const { return given_up_; }  ///< goals that a navigator aborted
  /// The longest time that one of them stood without a reason [s].
  double longestStanding() const;

 private:
  struct Robot {
    Robot(const std::string& name, const navigation::NavigatorParams& params);

    navigation::Navigator navigator;
    fleet::TrafficRule rule;
    ScanPlacer placer;
    std::optional<LaserScan2> scan;
    std::optional<Vec2> goal;
    bool new_goal = false;
    bool powered = true;
    navigation::NavigatorOutput output;
    StandingWatch standing;
  };

  void control(std::size_t index);
  void applyRule(Robot& robot, std::size_t index, navigation::NavigatorInputs& inputs);
  void tell();

  OccupancyGrid map_;
  sim::Simulator simulator_;
  bool rule_;
  std::vector<std::unique_ptr<Robot>> robots_;
  int given_up_ = 0;
  int steps_ = 0;
};

/// Two rooms joined by a corridor of 10 m, `width` [m] wide, and two robots with goals in each other's room. `seed`
/// determines where they start: in their rooms, or up to 4.5 m inside the corridor.
struct Meeting {
  OccupancyGrid map;
  std::vector<Pose2> starts;
  std::vector<Vec2> goals;
};
Meeting drawMeeting(int seed, double width);

}  // namespace frontier_pilot::test
