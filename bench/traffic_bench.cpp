// Robots that meet where there is no room for two: whether each meeting resolves, how long that takes, and how long a
// robot stands without saying why.

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/closed_loop/driven_fleet.h"
#include "support/named_limits.h"
#include "support/named_robot.h"
#include "tools/arguments.h"
#include "tools/program.h"

namespace frontier_pilot::bench {
namespace {

struct Options {
  std::vector<int> seeds = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  std::string robot;
  std::string limits = "fast";
  double width = 0.9;    ///< [m]
  double limit = 300.0;  ///< [s]
  bool no_rule = false;
  bool log = false;
};

Options parse(const std::vector<std::string>& words) {
  tools::Arguments arguments(words);
  Options options;
  while (!arguments.atEnd()) {
    const std::string word = arguments.next();
    if (word == "--seeds")
      options.seeds = arguments.range();
    else if (word == "--robot")
      options.robot = arguments.text();
    else if (word == "--limits")
      options.limits = arguments.text();
    else if (word == "--width")
      options.width = arguments.number();
    else if (word == "--limit")
      options.limit = arguments.number();
    else if (word == "--no-rule")
      options.no_rule = true;
    else if (word == "--log")
      options.log = true;
    else
      throw std::invalid_argument("unknown option " + word);
  }
  return options;
}

navigation::NavigatorParams paramsOf(const Options& options) {
  navigation::NavigatorParams params;
  params.robot = robotNamed(options.robot);
  if (!options.limits.empty()) params.robot.limits = limitsNamed(options.limits);
  return params;
}

void logStates(const test::DrivenFleet& fleet) {
  for (std::size_t i = 0; i < 2; ++i) {
    const navigation::NavigatorOutput& output = fleet.output(i);
    std::printf("   %6.1f robot%zu (%5.2f, %5.2f) %d contacts, %s: %s %s\n", toSeconds(fleet.now()), i + 1,
                fleet.pose(i).x, fleet.pose(i).y, fleet.contacts(), toString(output.state), toString(output.reason),
                output.traffic.c_str());
  }
}

int runAll(const Options& options) {
  int unresolved = 0;
  int contacts = 0;
  std::vector<double> times;
  std::printf("seed resolved  time [s]  contacts  given up  longest standing without a reason [s]\n");
  for (const int seed : options.seeds) {
    const test::Meeting meeting = test::drawMeeting(seed, options.width);
    test::DrivenFleet fleet(meeting.map, meeting.starts, paramsOf(options), !options.no_rule);
    for (std::size_t i = 0; i < meeting.goals.size(); ++i) fleet.send(i, meeting.goals[i]);
    bool done = false;
    while (!done && toSeconds(fleet.now()) < options.limit) {
      done = fleet.run(1.0);
      if (options.log) logStates(fleet);
    }
    std::printf("%4d %8s %9.1f %9d %9d %9.1f\n", seed, done ? "yes" : "no", toSeconds(fleet.now()), fleet.contacts(),
                fleet.given_up(), fleet.longestStanding());
    std::fflush(stdout);
    unresolved += done ? 0 : 1;
    contacts += fleet.contacts();
    times.push_back(toSeconds(fleet.now()));
  }
  std::sort(times.begin(), times.end());
  std::printf("%zu meetings, %d unresolved, %d contacts, median %.1f s, longest %.1f s\n", times.size(), unresolved,
              contacts, times[times.size() / 2], times.back());
  return unresolved == 0 && contacts == 0 ? 0 : 1;
}

constexpr const char* kUsage =
    "usage: traffic_bench [options]\n"
    "Two robots with goals behind each other meet in a corridor of 10 m: whether that resolves, and how soon.\n"
    "  --seeds A-B      where they start (1-10)\n"
    "  --width METRES   of the corridor (0.9)\n"
    "  --robot NAME     one of config/robots/; a Burger without it\n"
    "  --limits NAME    burger or fast (fast)\n"
    "  --limit SECONDS  of simulated time for each meeting (300)\n"
    "  --no-rule        the robots do not agree who goes first\n"
    "  --log            what both do, once a second\n"
    "Exit status 0: every meeting is resolved without contact.\n"
    "Example:\n"
    "  traffic_bench --seeds 1-50\n";

}  // namespace
}  // namespace frontier_pilot::bench

int main(int argc, char** argv) {
  namespace bench = frontier_pilot::bench;
  return frontier_pilot::tools::runProgram("traffic_bench", {argv + 1, argv + argc}, bench::kUsage,
                                           [](const auto& words) { return bench::runAll(bench::parse(words)); });
}
