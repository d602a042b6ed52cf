// What the operator's window says of the messages. [GUI-2]

#include "ros/teleop_gui/operator_views.h"

#include <gtest/gtest.h>

#include <limits>

namespace frontier_pilot {
namespace {

ExplorerStatus explorerStatus(int state, const char* state_text, int reason) {
  ExplorerStatus msg;
  msg.state = static_cast<std::uint8_t>(state);
  msg.state_text = state_text;
  msg.reason = static_cast<std::uint8_t>(reason);
  msg.phase_text = "RICH";
  return msg;
}

// [GUI-2]
TEST(OperatorViews, AnExplorerThatDoesNotExploreIsPausedOrWaits_GUI_2) {
  const auto unstarted = toView(explorerStatus(ExplorerStatus::IDLE, "IDLE", ExplorerStatus::PAUSED), 0.0);
  EXPECT_EQ(unstarted.state_text, "Not started");
  EXPECT_TRUE(unstarted.not_started);
  ExplorerStatus msg = explorerStatus(ExplorerStatus::IDLE, "IDLE", ExplorerStatus::PAUSED);
  msg.goals_sent = 1;
  const auto paused = toView(msg, 0.0);
  EXPECT_EQ(paused.state_text, "Paused");
  EXPECT_FALSE(paused.not_started);
  EXPECT_EQ(paused.phase_text, "");
  msg.reason_text = "paused";
  EXPECT_EQ(toView(msg, 0.0).reason_text, "Start lets it go on.") << "the state says already that it is paused";
  const auto waits = toView(explorerStatus(ExplorerStatus::IDLE, "IDLE", ExplorerStatus::OTHERS_GOAL), 0.0);
  EXPECT_EQ(waits.state_text, "Waiting");
  const auto drives = toView(explorerStatus(ExplorerStatus::NAVIGATING, "NAVIGATING", ExplorerStatus::GOAL_SENT), 0.0);
  EXPECT_EQ(drives.state_text, "NAVIGATING");
  EXPECT_EQ(drives.phase_text, "RICH");
}

// [GUI-2] Most goals are given up on the way, because all that they were chosen for has been seen by then.
TEST(OperatorViews, GoalsThatWereNeitherReachedNorFailedWereDropped_GUI_2) {
  ExplorerStatus msg = explorerStatus(ExplorerStatus::DONE, "DONE", ExplorerStatus::NO_REACHABLE_FRONTIER);
  msg.goals_sent = 24;
  EXPECT_EQ(toView(msg, 0.0).goals_dropped, 24U);
  msg.goals_reached = 3;
  msg.goals_failed = 1;
  EXPECT_EQ(toView(msg, 0.0).goals_dropped, 20U);
  msg.state = ExplorerStatus::NAVIGATING;
  EXPECT_EQ(toView(msg, 0.0).goals_dropped, 19U) << "the last one is under way";
  msg.goals_sent = 2;
  EXPECT_EQ(toView(msg, 0.0).goals_dropped, 0U);
}

// [GUI-2]
TEST(OperatorViews, ASourceThatHoldsTheRobotStillIsGrey_GUI_2) {
  ArbiterStatus msg;
  msg.state = ArbiterStatus::DRIVING;
  msg.active_source = "manual";
  msg.sources.resize(1);
  msg.sources[0].state = ArbiterSource::ACTIVE;
  EXPECT_EQ(toView(msg, 0.0).severity, teleop::Severity::kIdle);
  EXPECT_EQ(toView(msg, 0.0).sources[0].severity, teleop::Severity::kIdle);
  msg.command.angular.z = 0.2;
  EXPECT_EQ(toView(msg, 0.0).severity, teleop::Severity::kGood);
  EXPECT_EQ(toView(msg, 0.0).sources[0].severity, teleop::Severity::kActive);
}

// [GUI-2]
TEST(OperatorViews, ASourceThatWantsNothingIsGreyAndOneNeverHeardSaysSo_GUI_2) {
  ArbiterStatus msg;
  msg.sources.resize(4);
  msg.sources[0].state = ArbiterSource::IDLE;
  msg.sources[0].state_text = "alive, asks for nothing";
  msg.sources[1].state = ArbiterSource::READY;
  msg.sources[2].state = ArbiterSource::NEVER_HEARD;
  msg.sources[2].age = -1.0;
  msg.sources[3].state = ArbiterSource::NEVER_HEARD;  // since the stop was cleared
  msg.sources[3].age = 240.0;
  msg.sources[3].state_text = "waiting for a new command";
  const teleop::ArbiterView view = toView(msg, 0.0);
  EXPECT_EQ(view.sources[0].severity, teleop::Severity::kIdle);
  EXPECT_EQ(view.sources[0].state_text, "alive, asks for nothing");
  EXPECT_EQ(view.sources[1].severity, teleop::Severity::kGood);
  EXPECT_EQ(view.sources[2].state_text, "no command received yet");
  EXPECT_EQ(view.sources[3].state_text, "waiting for a new command");
}

// [GUI-2]
TEST(OperatorViews, ANavigationThatIsHinderedIsAWarningAndWithoutAPathSaysNoDistance_GUI_2) {
  NavigatorProgress msg;
  msg.status = "recovering (backing up): blocked";
  msg.distance_left = msg.time_left = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(toView(msg, 0.0).severity, teleop::Severity::kIdle) << "there is no goal any more";
  msg.has_goal = 1;
  msg.goal.position.x = 2.5;
  const teleop::NavigationView view = toView(msg, 0.0);
  EXPECT_EQ(view.severity, teleop::Severity::kWarning);
  EXPECT_EQ(view.goal, Vec2(2.5, 0.0));
  EXPECT_FALSE(view.distance_left || view.time_left);
  msg.status = "driving: on the way";
  EXPECT_EQ(toView(msg, 0.0).severity, teleop::Severity::kActive);
}

// [GUI-2]
TEST(OperatorViews, TheSectorsHaveTheDistancesThatTheAvoiderWasTunedTo_GUI_2) {
  dynamic_reconfigure::Config msg;
  msg.doubles.resize(3);
  msg.doubles[0].name = "stop_distance";
  msg.doubles[0].value = 0.7;
  msg.doubles[1].name = "clear_distance";
  msg.doubles[1].value = 0.9;
  msg.doubles[2].name = "turn_speed";
  msg.doubles[2].value = 9.0;
  const avoid::AvoiderParameters parameters = tuned({}, msg);
  EXPECT_EQ(parameters.stop_distance, 0.7);
  EXPECT_EQ(parameters.clear_distance, 0.9);
  EXPECT_EQ(parameters.turn_speed, avoid::AvoiderParameters().turn_speed) << "the window does not show it";
  msg.doubles[1].value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(tuned({}, msg).stop_distance, 0.0) << "nothing of a message that holds what cannot be";
}

}  // namespace
}  // namespace frontier_pilot
