#include "ros/common/inputs/start_grace.h"

#include <gtest/gtest.h>

#include "log_lines.h"
#include "ros/common/diagnostics.h"
#include "ros/common/inputs/input_watch.h"

namespace frontier_pilot {
namespace {

using Level = ros::console::Level;
using Line = LogLines::Line;
constexpr Level kInfo = ros::console::levels::Info;
constexpr Level kWarn = ros::console::levels::Warn;

SteadyTime inSeconds(double seconds) { return SteadyTime{} + fromSeconds(seconds); }

TEST(StartGrace, ANodeThatHasJustStartedTellsWhatItWaitsForAsNews) {
  const StartGrace grace(inSeconds(5.0));
  EXPECT_EQ(grace.level(inSeconds(5.0)), kInfo);
  EXPECT_EQ(grace.level(inSeconds(14.9)), kInfo);
  EXPECT_EQ(grace.level(inSeconds(15.0)), kWarn);
}

TEST(StartGrace, AMissingInputIsAWarningOnceTheStartIsOver_ROB_3) {  // [ROB-3]
  InputWatch watch;
  watch.need([](const InputWatch::Topics&) { return "nobody publishes /scan"; });
  const LogLines log;
  for (int t = 0; t <= 12; ++t) watch.look({}, inSeconds(t));
  EXPECT_EQ(log.lines, (std::vector<Line>{{kInfo, "waiting: nobody publishes /scan"},
                                          {kWarn, "waiting: nobody publishes /scan"}}));
}

TEST(StartGrace, AnInputThatIsLostLaterIsAWarning_ROB_3) {  // [ROB-3]
  std::string missing;
  InputWatch watch;
  watch.need([&](const InputWatch::Topics&) { return missing; });
  for (int t = 0; t <= 60; ++t) watch.look({}, inSeconds(t));
  missing = "nobody publishes /scan";
  const LogLines log;
  for (int t = 61; t <= 63; ++t) watch.look({}, inSeconds(t));
  EXPECT_EQ(log.lines, (std::vector<Line>{{kWarn, "waiting: nobody publishes /scan"}}));
}

/// The only line for a scan that came before what it needs, or that cannot be used at all, of a node that was started
/// `seconds` ago.
Line lineOfRefusal(double seconds, bool waits) {
  Rejections rejections("scan", StartGrace(steadyNow() - fromSeconds(seconds)));
  const LogLines log;
  waits ? rejections.addWaiting("no odometry") : rejections.add("malformed");
  EXPECT_EQ(rejections.total(), 1U);
  return log.lines.size() == 1 ? log.lines.front() : Line{};
}

TEST(StartGrace, ARefusedInputIsAWarningUnlessItOnlyCameBeforeOthersAtTheStart) {
  EXPECT_EQ(lineOfRefusal(0.0, true), Line(kInfo, "scan refused: no odometry (1 so far)"));
  EXPECT_EQ(lineOfRefusal(60.0, true), Line(kWarn, "scan refused: no odometry (1 so far)"));
  EXPECT_EQ(lineOfRefusal(0.0, false), Line(kWarn, "scan refused: malformed (1 so far)"));
}

}  // namespace
}  // namespace frontier_pilot
