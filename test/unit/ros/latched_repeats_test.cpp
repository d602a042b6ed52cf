#include "ros/common/messages/latched_repeats.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

namespace frontier_pilot {
namespace {

LatchedRepeats::Header connectionOf(const std::string& publisher, const std::string& latching = "1") {
  const auto header = boost::make_shared<ros::M_string>();
  (*header)["callerid"] = publisher;
  (*header)["latching"] = latching;
  return header;
}

LatchedRepeats withSettling(double seconds) {
  return {"/goal", timeFromSeconds<SteadyTime>(0.0), fromSeconds(seconds)};
}

/// A node that is not held up looks ten times a second.
void lookUntil(double end, LatchedRepeats& repeats, double begin = 0.0) {
  for (double time = begin; time < end; time += 0.1) repeats.look(timeFromSeconds<SteadyTime>(time));
}

TEST(LatchedRepeats, IsTheFirstMessageOfAnotherConnectionOfTheSamePublisher_ARB_8) {
  LatchedRepeats repeats = withSettling(0.0);
  const auto first = connectionOf("/pub"), second = connectionOf("/pub");
  EXPECT_FALSE(repeats.isRepeat(first, timeFromSeconds<SteadyTime>(1.0)));
  EXPECT_FALSE(repeats.isRepeat(first, timeFromSeconds<SteadyTime>(2.0)));
  EXPECT_TRUE(repeats.isRepeat(second, timeFromSeconds<SteadyTime>(3.0)));
  EXPECT_FALSE(repeats.isRepeat(second, timeFromSeconds<SteadyTime>(4.0)));
}

TEST(LatchedRepeats, AreNoMessagesOfOtherPublishersOrOfOnesThatDoNotLatch_ARB_2) {
  LatchedRepeats repeats = withSettling(10.0);
  lookUntil(1.0, repeats);
  EXPECT_FALSE(repeats.isRepeat(connectionOf("/joystick", "0"), timeFromSeconds<SteadyTime>(1.0)));
  EXPECT_FALSE(repeats.isRepeat(connectionOf("/joystick", ""), timeFromSeconds<SteadyTime>(1.0)));
  EXPECT_FALSE(repeats.isRepeat({}, timeFromSeconds<SteadyTime>(1.0)));
  lookUntil(11.0, repeats, 1.0);
  EXPECT_FALSE(repeats.isRepeat(connectionOf("/one"), timeFromSeconds<SteadyTime>(11.0)));
  EXPECT_FALSE(repeats.isRepeat(connectionOf("/another"), timeFromSeconds<SteadyTime>(12.0)));
}

TEST(LatchedRepeats, IsTheFirstMessageThatANewNodeHears_ARB_6) {
  LatchedRepeats repeats = withSettling(10.0);
  const auto connection = connectionOf("/pub");
  EXPECT_TRUE(repeats.isRepeat(connection, timeFromSeconds<SteadyTime>(9.0)));
  EXPECT_FALSE(repeats.isRepeat(connection, timeFromSeconds<SteadyTime>(9.5))) << "a second one is new";
}

TEST(LatchedRepeats, IsTheFirstMessageThatIsReadAfterALongStart_ARB_6) {
  LatchedRepeats repeats = withSettling(2.0);
  EXPECT_TRUE(repeats.isRepeat(connectionOf("/pub"), timeFromSeconds<SteadyTime>(3.0)));
  lookUntil(6.0, repeats, 3.1);
  EXPECT_FALSE(repeats.isRepeat(connectionOf("/later"), timeFromSeconds<SteadyTime>(6.0)));
}

TEST(LatchedRepeats, IsTheFirstMessageThatIsReadAfterAHoldUpOfANewNode_ARB_6) {
  LatchedRepeats repeats = withSettling(2.0), settled = withSettling(2.0);
  lookUntil(1.5, repeats);
  lookUntil(2.5, settled);
  repeats.look(timeFromSeconds<SteadyTime>(30.0));
  EXPECT_TRUE(repeats.isRepeat(connectionOf("/pub"), timeFromSeconds<SteadyTime>(30.1)));
  EXPECT_FALSE(settled.isRepeat(connectionOf("/pub"), timeFromSeconds<SteadyTime>(30.1)));
}

TEST(LatchedRepeats, AreNotAllFirstMessagesOfANodeThatIsAlwaysSlow_ARB_6) {
  LatchedRepeats repeats = withSettling(2.0);
  for (double time = 0.5; time < 7.0; time += 0.5) repeats.look(timeFromSeconds<SteadyTime>(time));
  EXPECT_FALSE(repeats.isRepeat(connectionOf("/pub"), timeFromSeconds<SteadyTime>(7.0)));
}

// [ARB-8] It hung when the node was started, and wakes later.
TEST(LatchedRepeats, IsTheFirstMessageOfAPublisherThatIsConnectedLate_ARB_8) {
  const auto at = [](double seconds) { return timeFromSeconds<SteadyTime>(seconds); };
  LateConnections late;
  LatchedRepeats after_a_restart("/goal", at(0.0), kSettling, late), others("/goal", at(0.0), Duration::zero(), late);
  late.note({{"/goal", "/hung"}, {"/goal", "/slow"}}, at(1.0));
  late.note({{"/goal", "/hung"}, {"/goal", "/slow"}}, at(1.4));
  late.note({{"/goal", "/hung"}}, at(2.0));
  late.note({{"/goal", "/hung"}}, at(3.0));
  lookUntil(3.5, after_a_restart);
  EXPECT_TRUE(after_a_restart.isRepeat(connectionOf("/hung"), at(3.5)));
  EXPECT_FALSE(after_a_restart.isRepeat(connectionOf("/slow"), at(3.5))) << "a connection takes its time to be made";
  EXPECT_FALSE(others.isRepeat(connectionOf("/hung"), at(3.5))) << "what waits for the first node is meant for it";
  EXPECT_FALSE(late.has("/other", "/hung", at(3.5)));
  EXPECT_FALSE(late.has("/goal", "/hung", at(6.0))) << "it was connected, and had nothing to send";
}

TEST(LatchedRepeats, ForgetsTheOldestOfManyPublishers_FLT_1) {
  LatchedRepeats repeats = withSettling(0.0);
  for (int i = 0; i < 1000; ++i)
    repeats.isRepeat(connectionOf("/pub" + std::to_string(i)), timeFromSeconds<SteadyTime>(1.0));
  EXPECT_TRUE(repeats.isRepeat(connectionOf("/pub999"), timeFromSeconds<SteadyTime>(2.0)));
  EXPECT_FALSE(repeats.isRepeat(connectionOf("/pub0"), timeFromSeconds<SteadyTime>(2.0)));
}

}  // namespace
}  // namespace frontier_pilot
