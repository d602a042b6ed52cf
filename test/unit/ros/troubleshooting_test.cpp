// docs/troubleshooting.md explains each message with which a node gives up.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "frontier_pilot/exploration/explorer_types.h"
#include "frontier_pilot/mapping/mapper.h"
#include "frontier_pilot/navigation/navigator_types.h"

namespace frontier_pilot {
namespace {

std::string thePage() {
  std::ifstream file(PROJECT_ROOT "/docs/troubleshooting.md");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The texts of an enumeration from 0 on that are not among the `good` ones, which nobody has to put right.
template <class Enumeration>
std::vector<std::string> badTexts(Enumeration last, const std::vector<std::string>& good) {
  std::vector<std::string> bad;
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    const std::string text = toString(static_cast<Enumeration>(i));
    if (std::find(good.begin(), good.end(), text) == good.end()) bad.push_back(text);
  }
  return bad;
}

void expectExplained(const std::vector<std::string>& texts) {
  const std::string page = thePage();
  EXPECT_FALSE(texts.empty());
  for (const std::string& text : texts) {
    const std::string name = text.substr(0, text.find(": "));  // the rest says it in other words
    EXPECT_NE(page.find("`" + name), std::string::npos) << "docs/troubleshooting.md does not explain: " << text;
  }
}

TEST(Troubleshooting, ExplainsEachReasonWithWhichANavigationEnds) {
  expectExplained(badTexts(navigation::kLastNavReason, {"no goal", "on the way", "turning to the goal's direction",
                                                        "goal reached", "gives way to another robot"}));
}

TEST(Troubleshooting, ExplainsEachReasonWithWhichAnExplorationWaitsOrEnds) {
  // What it waits for is said as "missing: map", for example, and not by the name of the reason.
  const std::vector<std::string> inputs = {"waiting for inputs",
                                           "map gone",
                                           "pose gone",
                                           "odometry gone",
                                           "navigation gone",
                                           "the robot is not localised on the map",
                                           "the arbiter does not heed the navigation"};
  expectExplained({"missing: ...", "exploration waits for: ..."});
  std::vector<std::string> bad =
      badTexts(exploration::ExplorerReason::kNavigationUnable,
               {"none", "all inputs are there", "goal sent", "goal reached", "goal failed", "goal timed out",
                "goal preempted by another client", "nothing left to see at the goal", "a better goal",
                "no rich frontier left", "all that is left is blacklisted, trying once more", "the map changed",
                "returning to the start", "reset", "the bounds have changed", "started again",
                "inspecting a pose that was asked for", "nothing is to be inspected any more"});
  for (const std::string& input : inputs) bad.erase(std::remove(bad.begin(), bad.end(), input), bad.end());
  expectExplained(bad);
}

TEST(Troubleshooting, ExplainsEachReasonForWhichAScanIsDropped) {
  const auto last = static_cast<mapping::ScanVerdict>(mapping::kScanVerdicts - 1);
  expectExplained(badTexts(last, {"inserted", "localised", "not moved"}));
}

}  // namespace
}  // namespace frontier_pilot
