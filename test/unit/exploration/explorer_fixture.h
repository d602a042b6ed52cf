#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "frontier_pilot/exploration/explorer.h"
#include "support/ascii_world.h"

namespace frontier_pilot::test {

/// An explorer with all its inputs in the test's hands; time passes by ticks of 0.1 s.
class ExplorerTest : public ::testing::Test {
 protected:
  /// A room whose right end is unknown. The robot is at 'r'.
  static constexpr const char* kRoom = R"(
    ##############################????
    #.............................????
    #.............................????
    #.............................????
    #.............................????
    #....r........................????
    #.............................????
    #.............................????
    #.............................????
    #.............................????
    ##############################????
  )";
  /// The same with nothing left to see.
  static constexpr const char* kClosedRoom = R"(
    ##################################
    #.............................####
    #.............................####
    #.............................####
    #.............................####
    #....r........................####
    #.............................####
    #.............................####
    #.............................####
    #.............................####
    ##################################
  )";
  /// Two ways on: the left end is nearer to the robot.
  static constexpr const char* kTwoEnds = R"(
    ????########################################????
    ????........................................????
    ????........................................????
    ????........................................????
    ????........................................????
    ????..............r.........................????
    ????........................................????
    ????........................................????
    ????........................................????
    ????........................................????
    ????########################################????
  )";

  /// A scanner that sees 1 m, so that the ends of the drawings are apart.
  static exploration::ExplorerParameters shortSighted() {
    exploration::ExplorerParameters parameters;
    parameters.frontier.view.sensor_range = 1.0;
    parameters.tour.put_off_share = parameters.tour.left_share = 0.0;  // the drawings are small
    return parameters;
  }

  explicit ExplorerTest(const exploration::ExplorerParameters& parameters = shortSighted()) : explorer(parameters) {}

  void show(const std::string& drawing) {
    world = drawWorld(drawing);
    explorer.setMap(world.map, world.map.geometry().rect());
    if (world.marks.count('r') != 0 && !placed_) pose = Pose2(world.point('r'), 0.0);
    placed_ = true;
  }
  void change(const CellRect& block, std::int8_t value) {
    for (int y = block.y; y < block.y + block.height; ++y) std::fill_n(world.map.row(y) + block.x, block.width, value);
    explorer.setMap(world.map, block);
  }

  /// One tick with all inputs there, but for what the test took away.
  exploration::ExplorerOutput tick() {
    inputs.T_map_base.reset();
    inputs.odometry_stamp.reset();
    if (pose_comes) inputs.T_map_base = StampedPose2{now, pose};
    if (odometry_comes) inputs.odometry_stamp = now - odometry_age;
    exploration::ExplorerOutput output = explorer.update(inputs, now);
    inputs.goal_events.clear();
    inputs.reset = false;
    if (output.command.kind == exploration::GoalCommand::Kind::kSend) sent = output.command;
    history.insert(history.end(), output.transitions.begin(), output.transitions.end());
    notes.insert(notes.end(), output.notes.begin(), output.notes.end());
    now += fromSeconds(0.1);
    return output;
  }
  exploration::ExplorerOutput tickFor(double seconds) {
    exploration::ExplorerOutput output = tick();
    for (const Time end = now + fromSeconds(seconds); now < end;) {
      const exploration::GoalCommand kept = output.command;
      output = tick();
      if (output.command.kind == exploration::GoalCommand::Kind::kNone) output.command = kept;
    }
    return output;
  }
  void goalEnds(exploration::GoalEvent::Kind kind, const std::string& text = "") {
    inputs.goal_events = {{sent.goal_id, kind, text}};
  }

  bool wentThrough(exploration::ExplorerState state, exploration::ExplorerReason reason) const {
    return std::any_of(history.begin(), history.end(),
                       [&](const exploration::ExplorerProgress& p) { return p.state == state && p.reason == reason; });
  }
  std::size_t notesWith(const std::string& words) const {
    return static_cast<std::size_t>(std::count_if(notes.begin(), notes.end(), [&](const exploration::ExplorerNote& n) {
      return n.text.find(words) != std::string::npos;
    }));
  }

  exploration::Explorer explorer;
  exploration::ExplorerInputs inputs;
  AsciiWorld world;
  Pose2 pose;
  Time now = timeFromSeconds(100.0);
  bool pose_comes = true;
  bool odometry_comes = true;
  Duration odometry_age{};
  exploration::GoalCommand sent;
  std::vector<exploration::ExplorerProgress> history;
  std::vector<exploration::ExplorerNote> notes;

 private:
  bool placed_ = false;
};

}  // namespace frontier_pilot::test
