// When the copy of the map is written that a mapper leaves behind. [FLT-2]

#include "ros/mapper/save_schedule.h"

#include <gtest/gtest.h>

#include <chrono>

namespace frontier_pilot {
namespace {

SteadyTime at(int seconds) { return SteadyTime(std::chrono::seconds(1000 + seconds)); }
constexpr Duration kTook = std::chrono::seconds(5);

/// Whose map with the content 1 was kept at 5 s, which took five seconds.
SaveSchedule withCopy() {
  SaveSchedule schedule;
  schedule.begin(1, at(0));
  schedule.end(true, at(5), kTook);
  return schedule;
}

// [FLT-2]
TEST(SaveSchedule, SavesOneMapAtATimeIfItHasChangedAndTakesATwentiethOfTheTime_FLT_2) {
  SaveSchedule schedule;
  EXPECT_TRUE(schedule.isDue(0, at(0)));
  schedule.begin(0, at(0));
  EXPECT_FALSE(schedule.isDue(1, at(4)));
  EXPECT_FALSE(schedule.hasCopy());
  schedule.end(true, at(5), kTook);
  EXPECT_TRUE(schedule.hasCopy());
  EXPECT_FALSE(schedule.isDue(1, at(104)));
  EXPECT_TRUE(schedule.isDue(1, at(105)));
  EXPECT_FALSE(schedule.isDue(0, at(105)));
}

// After a map that takes long to save another one is loaded. [FLT-2]
TEST(SaveSchedule, SavesAtOnceWhatComesInPlaceOfTheCopy_FLT_2) {
  SaveSchedule schedule = withCopy();
  schedule.discard();
  EXPECT_FALSE(schedule.hasCopy());
  EXPECT_TRUE(schedule.isDue(1, at(6)));
}

// At the end the copy may stay as the only map. [FLT-2]
TEST(SaveSchedule, DoesNotRestBeforeTheLastSave_FLT_2) {
  SaveSchedule schedule = withCopy();
  EXPECT_FALSE(schedule.isDue(2, at(6)));
  schedule.hurry();
  EXPECT_TRUE(schedule.isDue(2, at(6)));
  EXPECT_FALSE(schedule.isDue(1, at(6))) << "that map is kept already";
}

// [FLT-2]
TEST(SaveSchedule, TakesASaveThatWasDiscardedMeanwhileForNoCopyAndDoesNotRestAfterIt_FLT_2) {
  SaveSchedule schedule = withCopy();
  schedule.begin(2, at(105));
  schedule.discard();
  EXPECT_FALSE(schedule.isDue(2, at(106))) << "the disk is busy with the one before it";
  schedule.end(true, at(110), kTook);
  EXPECT_FALSE(schedule.hasCopy());
  EXPECT_TRUE(schedule.isDue(2, at(110)));
}

// [FLT-2]
TEST(SaveSchedule, TriesAgainSoonAfterAFailureAndKeepsTheCopyOfBefore_FLT_2) {
  SaveSchedule schedule = withCopy();
  schedule.begin(2, at(105));
  schedule.end(false, at(110), kTook);
  EXPECT_TRUE(schedule.hasCopy());
  EXPECT_FALSE(schedule.isDue(2, at(124)));
  EXPECT_TRUE(schedule.isDue(2, at(125)));
}

// Otherwise nobody would know of a disk that does not answer. [FLT-2]
TEST(SaveSchedule, SaysWhenASaveDoesNotEnd_FLT_2) {
  SaveSchedule schedule = withCopy();
  EXPECT_EQ(schedule.delay(at(5000)), "");
  schedule.begin(2, at(5000));
  EXPECT_EQ(schedule.delay(at(5029)), "");
  EXPECT_NE(schedule.delay(at(5047)).find("not been kept for 47 s"), std::string::npos) << schedule.delay(at(5047));
  schedule.end(true, at(5050), kTook);
  EXPECT_EQ(schedule.delay(at(5050)), "");
}

}  // namespace
}  // namespace frontier_pilot
