#include "teleop/operator_events.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

teleop::OperatorState quietState() {
  teleop::OperatorState state;
  state.emergency_stop = false;
  state.arbiter = teleop::ArbiterView{};
  state.explorer = teleop::ExplorerView{};
  state.explorer->state_text = "IDLE";
  state.explorer->reason_text = "paused";
  return state;
}

class Journal : public ::testing::Test {
 protected:
  std::vector<std::string> lines() const {
    std::vector<std::string> texts;
    for (const teleop::OperatorLogLine& line : teleop::eventsBetween(before_, now_)) texts.push_back(line.text);
    return texts;
  }

  teleop::OperatorState before_ = quietState(), now_ = quietState();
};

using Lines = std::vector<std::string>;

TEST_F(Journal, IsSilentWhileNothingHappens) {
  EXPECT_EQ(lines(), Lines());
  before_ = {};
  EXPECT_EQ(lines(), Lines()) << "what is found at the start is no event";
  EXPECT_TRUE(teleop::eventsBetween({}, {}).empty());
}

// [GUI-2]
TEST_F(Journal, TellsTheEmergencyStopWithItsCauseAndItsClearing) {
  now_.emergency_stop = true;
  now_.arbiter->stop_cause = "emergency_stop called by /somebody";
  now_.arbiter->problems = {"emergency stop: emergency_stop called by /somebody"};
  EXPECT_EQ(lines(), Lines{"emergency stop: emergency_stop called by /somebody"});
  std::swap(before_, now_);
  EXPECT_EQ(lines(), Lines{"emergency stop cleared"});
  now_.emergency_stop.reset();
  EXPECT_EQ(lines(), Lines()) << "a topic that fell silent has cleared nothing";
}

// [GUI-2]
TEST_F(Journal, TellsAContactOnceAndWhoDroveTheRobotThere) {
  now_.contact = true;
  now_.arbiter->active_source = before_.arbiter->active_source = "patrol";
  EXPECT_EQ(lines(), Lines{"the robot touches something while patrol drives"});
  before_ = now_;
  EXPECT_EQ(lines(), Lines());
}

// [GUI-2]
TEST_F(Journal, TellsWhoTakesTheWheels) {
  now_.arbiter->active_source = "nav";
  EXPECT_EQ(lines(), Lines{"nav holds the robot still"});
  now_.arbiter->command = {0.1, 0.0};
  EXPECT_EQ(lines(), Lines{"nav drives"});
  std::swap(before_, now_);
  EXPECT_EQ(lines(), Lines{"nobody drives"});
}

TEST_F(Journal, TellsANewProblemOnce) {
  now_.arbiter->problems = {"/x publishes /cmd_vel as well"};
  EXPECT_EQ(lines(), Lines{"/x publishes /cmd_vel as well"});
  before_ = now_;
  EXPECT_EQ(lines(), Lines());
}

TEST_F(Journal, TellsEachStepOfTheExplorer) {
  now_.explorer->state_text = "NAVIGATING";
  now_.explorer->reason_text = "goal sent: 2 m away";
  EXPECT_EQ(lines(), Lines{"explorer: NAVIGATING, goal sent: 2 m away"});
  before_ = now_;
  now_.explorer->explored_area = 12.0;
  EXPECT_EQ(lines(), Lines()) << "figures are no step";
  now_.explorer->reason_text = "better goal: 1 m away";
  EXPECT_EQ(lines(), Lines{"explorer: NAVIGATING, better goal: 1 m away"});
}

TEST_F(Journal, TellsWhoFallsSilent) {
  now_.arbiter->status_age = now_.explorer->status_age = 2.0 * teleop::kStatusLifetime;
  EXPECT_EQ(lines(), (Lines{"the arbiter fell silent", "the explorer fell silent"}));
}

TEST_F(Journal, TellsWhenTheAvoiderIsInTrouble) {
  before_.avoider = teleop::AvoiderView{};
  now_.avoider = teleop::AvoiderView{};
  now_.avoider->severity = teleop::Severity::kError;
  now_.avoider->state_text = "stuck: after 12 cycles";
  EXPECT_EQ(lines(), Lines{"avoider: stuck: after 12 cycles"});
  before_ = now_;
  EXPECT_EQ(lines(), Lines());
}

TEST_F(Journal, TellsEachLegOfAPatrol) {
  now_.patrol.feedback = "line 2";
  EXPECT_EQ(lines(), Lines{"patrol: line 2"});
  before_ = now_;
  EXPECT_EQ(lines(), Lines());
}

}  // namespace
}  // namespace frontier_pilot
