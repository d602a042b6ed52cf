#include "ros/common/inputs/stop_follower.h"

#include <gtest/gtest.h>

#include <string>

namespace frontier_pilot {
namespace {

class StopFollowerOfAServer : public ::testing::Test {
 protected:
  void tick(bool catching_up = false) { follower.tick(publishers, hold_ups, catching_up); }
  void take(bool stopped) { follower.take(stopped, hold_ups); }
  void count(std::uint64_t stops, bool stopped, const std::string& node = "/arbiter") {
    follower.count(node, stops, stopped, hold_ups);
  }

  std::string told;  ///< S for a stop, c for a clear
  StopFollower::Uris publishers{"http://arbiter:1"};
  StopFollower::Uris living = publishers;
  int hold_ups = 0;
  StopFollower follower{[this](bool stopped) { told += stopped ? 'S' : 'c'; },
                        [this](const StopFollower::Uris& uris) { return uris == living; }};
};

// [FLT-2]
TEST_F(StopFollowerOfAServer, IsToldOfEachStopAndOnceMoreBeforeItsClear) {
  take(false);
  take(true);
  take(false);
  tick();
  EXPECT_EQ(told, "cSSc");
}

// [FLT-2] A goal of that time may be read after both.
TEST_F(StopFollowerOfAServer, TellsTheStopOnceMoreAndThenTheClearWhenItHasCaughtUp_FLT_2) {
  take(false);
  tick();
  ++hold_ups;
  take(true);
  take(false);
  tick(true);
  EXPECT_EQ(told, "cS");
  tick();
  EXPECT_EQ(told, "cSSc");
  tick();
  EXPECT_EQ(told, "cSSc");
}

// [FLT-2] A goal that was read meanwhile waits for the first tick of its server.
TEST_F(StopFollowerOfAServer, TellsTheStopOnceMoreAlsoIfTheClearComesJustAfterItHasCaughtUp_FLT_2) {
  take(false);
  tick();
  ++hold_ups;
  take(true);
  tick(true);
  take(false);  // later than the process had to catch up, but before the tick
  EXPECT_EQ(told, "cS");
  tick();
  EXPECT_EQ(told, "cSSc");
  take(true);
  take(false);
  EXPECT_EQ(told, "cSScSSc");
}

// [FLT-2] What the arbiter had sent is lost with it, and the one that follows is cleared already.
TEST_F(StopFollowerOfAServer, TakesTheDeathOfTheArbiterDuringAHoldUpForAStop_FLT_2) {
  take(false);
  tick();
  ++hold_ups;
  living = publishers = {"http://arbiter:2"};
  tick(true);
  EXPECT_EQ(told, "cS");
  take(false);
  EXPECT_EQ(told, "cS") << "goals are still being read";
  tick();
  EXPECT_EQ(told, "cSSc");
  ++hold_ups;
  tick(true);
  tick();
  EXPECT_EQ(told, "cSSc") << "the new one lives";
}

// [FLT-2]
TEST_F(StopFollowerOfAServer, NoticesTheDeathAlsoByTheFirstMessageOfTheNextArbiter_FLT_2) {
  take(false);
  tick();
  ++hold_ups;
  living = {"http://arbiter:2"};
  take(false);
  EXPECT_EQ(told, "cS");
  tick();
  EXPECT_EQ(told, "cSSc");
}

// [FLT-2] That one says by itself when it is cleared.
TEST_F(StopFollowerOfAServer, StaysStoppedWhenTheArbiterDiesWhileItIsStopped_FLT_2) {
  take(true);
  tick();
  ++hold_ups;
  living = publishers = {"http://arbiter:2"};
  tick(true);
  tick();
  EXPECT_EQ(told, "S");
  take(true);
  take(false);
  EXPECT_EQ(told, "SSSc");
}

// [FLT-2] A node that is not connected to the next one yet, when it is held up, cannot have read of its stop.
TEST_F(StopFollowerOfAServer, TakesAHoldUpBetweenTwoArbitersForAStop_FLT_2) {
  take(false);
  tick();
  living = publishers = {};
  tick();
  EXPECT_EQ(told, "c");
  ++hold_ups;
  living = publishers = {"http://arbiter:2"};
  tick(true);
  tick();
  EXPECT_EQ(told, "cSSc");
}

// [FLT-2] Without a hold-up nothing was missed, nor is there anything to miss before the first arbiter.
TEST_F(StopFollowerOfAServer, InventsNoStopWhenAnArbiterIsReplacedOrThereWasNone_FLT_2) {
  publishers = {};
  tick();
  ++hold_ups;
  tick(true);
  tick();
  EXPECT_EQ(told, "");
  publishers = {"http://arbiter:1"};
  take(false);
  tick();
  living = publishers = {"http://arbiter:2"};
  take(false);
  tick();
  EXPECT_EQ(told, "cc");
}

// [ARB-8] [FLT-2] A node that is connected to the next arbiter only after both, without having been held up.
TEST_F(StopFollowerOfAServer, IsToldOfAStopThatOnlyTheCountOfTheNextArbiterTellsOf_ARB_8_FLT_2) {
  take(false);
  count(3, false);
  living = publishers = {"http://arbiter:2"};
  take(false);
  tick();
  EXPECT_EQ(told, "cc");
  count(4, false);
  EXPECT_EQ(told, "ccSc");
  count(4, false);
  EXPECT_EQ(told, "ccSc") << "once";
  count(5, true);
  EXPECT_EQ(told, "ccScS") << "its clear is still to come";
  take(true);
  take(false);
  EXPECT_EQ(told, "ccScSSSc");
}

// [FLT-2] The count of a stop that was heard comes later, with a status.
TEST_F(StopFollowerOfAServer, IsNotToldOnceMoreOfAStopThatItHasHeardByItsCount_FLT_2) {
  count(3, false);
  take(true);
  count(4, true);
  take(false);
  count(4, false);
  take(true);
  take(false);
  count(5, false);
  EXPECT_EQ(told, "SScSSc");
  count(6, false);
  EXPECT_EQ(told, "SScSScSc") << "this one it has not heard";
}

// [FLT-2]
TEST_F(StopFollowerOfAServer, TakesACountThatBeginsAnewForNoStopUnlessThereAreAnyInIt_FLT_2) {
  count(3, false);
  count(0, false);
  EXPECT_EQ(told, "");
  count(3, false);
  told.clear();
  count(1, false);
  EXPECT_EQ(told, "Sc");
}

// [FLT-2] The message of the clear was the first one that it has read.
TEST_F(StopFollowerOfAServer, IsToldOfTheClearByTheStatusIfOnlyThatTellsOfTheStop_FLT_2) {
  count(3, false);
  take(false);
  count(4, true);
  EXPECT_EQ(told, "cS");
  count(4, false);
  EXPECT_EQ(told, "cSc");
  count(4, false);
  EXPECT_EQ(told, "cSc");
}

// [FLT-2]
TEST_F(StopFollowerOfAServer, IsNotToldTwiceOfAStopBeforeWhichAStatusWasSent_FLT_2) {
  count(3, false);
  take(true);
  count(3, false);  // sent before the stop, and read after it
  take(false);
  count(4, false);
  EXPECT_EQ(told, "SSc");
}

// [FLT-2] A stop that its arbiter has lost is no reason to miss a later one.
TEST_F(StopFollowerOfAServer, IsToldOfAMissedStopAfterOneThatWasNeverCounted_FLT_2) {
  count(3, false);
  take(true);
  take(false);
  told.clear();
  for (int i = 0; i < 50; ++i) tick();
  count(3, false);
  count(4, false);
  EXPECT_EQ(told, "Sc");
}

// [FLT-2] A goal from before the stop may be read after the status.
TEST_F(StopFollowerOfAServer, WaitsUntilItHasCaughtUpWithAClearThatAStatusTellsOf_FLT_2) {
  count(3, false);
  take(false);
  tick();
  ++hold_ups;
  count(4, false);
  tick(true);
  EXPECT_EQ(told, "cS");
  tick();
  EXPECT_EQ(told, "cSSc");
}

// [FLT-2] A recording that is played on the arbiter's topic has counted stops of another day. It may have taken the
// place of the arbiter, so it counts once.
TEST_F(StopFollowerOfAServer, ComparesTheCountsOfEachNodeByItself_FLT_2) {
  take(false);
  tick();
  told.clear();
  for (int i = 0; i < 5; ++i) {
    count(3, false);
    count(7, false, "/play");
  }
  EXPECT_EQ(told, "Sc");
  count(4, false);
  EXPECT_EQ(told, "ScSc") << "a stop that was missed";
  count(8, true, "/play");
  count(4, false);
  EXPECT_EQ(told, "ScScS") << "only who has counted it can say that it is over";
  count(8, false, "/play");
  EXPECT_EQ(told, "ScScSc");
}

// [FLT-2]
TEST_F(StopFollowerOfAServer, DoesNotStayStoppedByTheCountOfANodeThatHasFallenSilent_FLT_2) {
  take(false);
  tick();
  told.clear();
  count(3, false);
  count(7, true, "/play");
  for (int i = 0; i < 90; ++i) tick();
  count(7, true, "/play");
  for (int i = 0; i < 90; ++i) tick();
  EXPECT_EQ(told, "S");
  for (int i = 0; i < 20; ++i) tick();
  EXPECT_EQ(told, "Sc");
}

// [FLT-2] Other clients of ROS may give no name.
TEST_F(StopFollowerOfAServer, DoesNotTakeTheStatusOfANodeWithoutANameForAClear_FLT_2) {
  count(3, false, "");
  take(true);
  tick();
  told.clear();
  count(3, false, "");
  EXPECT_EQ(told, "");
}

// [FLT-2]
TEST_F(StopFollowerOfAServer, TellsAFewNodesApartThatCount_FLT_2) {
  for (int i = 0; i < 1000; ++i) count(3, false, "/play_" + std::to_string(i));
  EXPECT_EQ(told, "");
  count(4, false, "/arbiter");
  EXPECT_EQ(told, "Sc");
}

}  // namespace
}  // namespace frontier_pilot
