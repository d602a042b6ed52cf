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

TEST(LatchedRepeats, IsTheFirstMessageOfAnotherConnectionOfTheSamePublisher_ARB_8) {
  LatchedRepeats repeats;
  const auto first = connectionOf("/pub"), second = connectionOf("/pub");
  EXPECT_FALSE(repeats.isRepeat(first, timeFromSeconds<SteadyTime>(1.0)));
  EXPECT_FALSE(repeats.isRepeat(first, timeFromSeconds<SteadyTime>(2.0)));
  EXPECT_TRUE(repeats.isRepeat(second, timeFromSeconds<SteadyTime>(3.0)));
  EXPECT_FALSE(repeats.isRepeat(second, timeFromSeconds<SteadyTime>(4.0)));
}

TEST(LatchedRepeats, AreNoMessagesOfOtherPublishersOrOfOnesThatDoNotLatch_ARB_2) {
  LatchedRepeats repeats(timeFromSeconds<SteadyTime>(10.0));
  EXPECT_FALSE(repeats.isRepeat(connectionOf("/joystick", "0"), timeFromSeconds<SteadyTime>(1.0)));
  EXPECT_FALSE(repeats.isRepeat(connectionOf("/joystick", ""), timeFromSeconds<SteadyTime>(2.0)));
  EXPECT_FALSE(repeats.isRepeat({}, timeFromSeconds<SteadyTime>(2.0)));
  EXPECT_FALSE(repeats.isRepeat(connectionOf("/one"), timeFromSeconds<SteadyTime>(11.0)));
  EXPECT_FALSE(repeats.isRepeat(connectionOf("/another"), timeFromSeconds<SteadyTime>(12.0)));
}

TEST(LatchedRepeats, IsTheFirstMessageThatANewNodeHears_ARB_6) {
  LatchedRepeats repeats(timeFromSeconds<SteadyTime>(10.0));
  const auto connection = connectionOf("/pub");
  EXPECT_TRUE(repeats.isRepeat(connection, timeFromSeconds<SteadyTime>(9.0)));
  EXPECT_FALSE(repeats.isRepeat(connection, timeFromSeconds<SteadyTime>(9.5))) << "a second one is new";
}

TEST(LatchedRepeats, ForgetsTheOldestOfManyPublishers_FLT_1) {
  LatchedRepeats repeats;
  for (int i = 0; i < 1000; ++i)
    repeats.isRepeat(connectionOf("/pub" + std::to_string(i)), timeFromSeconds<SteadyTime>(1.0));
  EXPECT_TRUE(repeats.isRepeat(connectionOf("/pub999"), timeFromSeconds<SteadyTime>(2.0)));
  EXPECT_FALSE(repeats.isRepeat(connectionOf("/pub0"), timeFromSeconds<SteadyTime>(2.0)));
}

}  // namespace
}  // namespace frontier_pilot
