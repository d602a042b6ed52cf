// The drawings of the state machines in docs/architecture.md, held against the code: they name the code's states, and
// draw every transition that simulated runs make.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <random>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "frontier_pilot/arbiter/status.h"
#include "frontier_pilot/avoid/avoider.h"
#include "frontier_pilot/system/closed_loop.h"
#include "support/ascii_world.h"
#include "support/floors/driven_robot.h"

namespace frontier_pilot::test {
namespace {

using States = std::set<std::string>;
using Transition = std::pair<std::string, std::string>;

std::string architecturePage() {
  std::ifstream file(ARCHITECTURE_PAGE);
  std::stringstream page;
  page << file.rdbuf();
  return page.str();
}

/// The drawing that holds `state`, up to the end of its block.
std::string drawingOf(const std::string& state) {
  const std::string text = architecturePage();
  const std::size_t found = text.find("[*] --> " + state);
  if (found == std::string::npos) return {};
  return text.substr(found, text.find("```", found) - found);
}

std::set<Transition> drawnTransitions(const std::string& drawing) {
  std::set<Transition> transitions;
  const std::regex arrow(R"((\w+) --> (\w+))");
  for (auto it = std::sregex_iterator(drawing.begin(), drawing.end(), arrow); it != std::sregex_iterator(); ++it) {
    transitions.insert({(*it)[1], (*it)[2]});
  }
  return transitions;
}

States statesOf(const std::set<Transition>& transitions) {
  States states;
  for (const auto& [from, to] : transitions) states.insert({from, to});
  return states;
}

/// A state's name as it is drawn.
std::string drawn(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return c == ' ' ? '_' : static_cast<char>(std::toupper(c)); });
  return name;
}

template <class State>
States namesUpTo(State last) {
  States names;
  for (int i = 0; i <= static_cast<int>(last); ++i) names.insert(drawn(toString(static_cast<State>(i))));
  return names;
}

/// Notes the states that a machine is in, and fails at a transition that is not drawn.
class Follower {
 public:
  Follower(std::set<Transition> allowed, std::string start) : drawn_(std::move(allowed)), state_(std::move(start)) {}

  void enter(const std::string& state) {
    if (state == state_) return;
    EXPECT_TRUE(drawn_.count({state_, state}) != 0) << state_ << " --> " << state << " is not drawn";
    seen.insert({state_, state});
    state_ = state;
  }

  std::set<Transition> seen;

 private:
  std::set<Transition> drawn_;
  std::string state_;
};

TEST(StateMachines, TheDrawingOfTheExplorerIsThatOfTheCode) {
  const auto transitions = drawnTransitions(drawingOf("IDLE\n    IDLE --> SELECT_GOAL"));
  EXPECT_EQ(statesOf(transitions), namesUpTo(exploration::ExplorerState::kDone));
  const AsciiWorld world = drawWorld(R"(
    ####################################################
    #.................................................##
    #.................................................##
    #......S..........#################...............##
    #.................#################...............##
    #.................................................##
    #.................................................##
    ####################################################)",
                                     0.15);
  system::ClosedLoopParameters parameters;
  parameters.explorer.return_to_start = true;
  system::ClosedLoop loop(sim::World{world.map, Pose2(world.point('S'), 0.0)}, parameters);
  Follower follower(transitions, "IDLE");
  while (!loop.done() && toSeconds(loop.now()) < 600.0) {
    loop.step();
    for (const std::string& line : loop.takeLog()) {
      std::istringstream words(line);
      std::string time, state;
      words >> time >> state;
      if (state.back() == ':') follower.enter(state.substr(0, state.size() - 1));
    }
  }
  EXPECT_TRUE(loop.done()) << loop.status().reason_text;
  EXPECT_GE(follower.seen.size(), 4U);
}

TEST(StateMachines, TheDrawingOfTheNavigatorIsThatOfTheCode) {
  const auto transitions = drawnTransitions(drawingOf("IDLE\n    IDLE --> DRIVING"));
  EXPECT_EQ(statesOf(transitions), namesUpTo(navigation::NavState::kWaiting));
  const AsciiWorld world = drawWorld(R"(
    ########################################
    #......................................#
    #......................................#
    #....S.................................#
    #......................................#
    #......................................#
    ########################################)",
                                     0.1);
  DrivenRobot robot(world, {world.point('S'), 0.0});
  Follower follower(transitions, "IDLE");
  std::mt19937 dice(1);
  const auto pick = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(dice); };
  for (int tick = 0; tick < 8000; ++tick) {
    const int what = pick(400);
    if (what == 0) robot.cancel();
    if (what < 4) robot.sendPose({0.4 + 0.1 * pick(32), 0.3 + 0.05 * pick(5), 1.0 * pick(6)}, what != 3, tick + 1U);
    if (what == 4) robot.has_scan = !robot.has_scan;
    if (what > 390) robot.has_scan = true;
    follower.enter(drawn(toString(robot.tick().state)));
  }
  EXPECT_GE(follower.seen.size(), 6U);
}

LaserScan2 scanWith(double ahead, double behind, Time stamp) {
  LaserScan2 scan;
  constexpr int kBeams = 360;
  scan.stamp = stamp;
  scan.angle_increment = 2.0 * kPi / kBeams;
  scan.range_min = 0.1;
  scan.range_max = 8.0;
  scan.ranges.assign(kBeams, 4.0F);
  for (int i = -40; i < 40; ++i) {
    scan.ranges[static_cast<std::size_t>((i + kBeams) % kBeams)] = static_cast<float>(ahead);
    scan.ranges[static_cast<std::size_t>(i + kBeams / 2)] = static_cast<float>(behind);
  }
  return scan;
}

TEST(StateMachines, TheDrawingOfTheAvoiderIsThatOfTheCode) {
  const auto transitions = drawnTransitions(drawingOf("WAITING"));
  EXPECT_EQ(statesOf(transitions), namesUpTo(avoid::AvoiderState::kStuck));
  avoid::Avoider avoider{avoid::AvoiderParameters{}};
  Follower follower(transitions, "WAITING");
  std::mt19937 dice(1);
  const auto pick = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(dice); };
  Time now = timeFromSeconds(100.0);
  double ahead = 4.0;
  double behind = 4.0;
  for (int tick = 0; tick < 50000; ++tick) {
    now += std::chrono::milliseconds(100);
    const int what = pick(200);
    if (what < 10) ahead = pick(2) == 0 ? 0.3 : 4.0;
    if (what >= 10 && what < 15) behind = pick(2) == 0 ? 0.15 : 4.0;
    if (what == 20) avoider.setEnabled(!avoider.enabled(), now);
    follower.enter(drawn(toString(avoider.state())));
    if (what == 21) now += std::chrono::seconds(1);  // no scan for that long
    if (what == 22) avoider.onBadScan("not readable", now);
    if (what == 22) follower.enter(drawn(toString(avoider.state())));
    if (what != 21) avoider.onScan(scanWith(ahead, behind, now), now);
    follower.enter(drawn(toString(avoider.state())));
    avoider.tick(now);
    follower.enter(drawn(toString(avoider.state())));
  }
  EXPECT_GE(follower.seen.size(), 14U);
}

TEST(StateMachines, TheDrawingOfTheArbiterNamesItsStates) {
  const std::string page = architecturePage();
  for (const std::string& state : namesUpTo(arbiter::ArbiterState::kUnreachable)) {
    EXPECT_NE(page.find("| " + state + "\n"), std::string::npos) << state;
  }
}

}  // namespace
}  // namespace frontier_pilot::test
