#include "frontier_pilot/mapping/map_schedule.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

constexpr std::size_t kCells = 1000;

Time at(double seconds) { return timeFromSeconds(100.0 + seconds); }

occupancy::MapChanges changed(int cells) { return {false, {0, 0, cells, 1}}; }

/// One that has sent a whole map at 0 s.
mapping::MapSchedule begun() {
  mapping::MapSchedule schedule;
  schedule.note({true, {0, 0, 100, 10}}, at(0.0));
  schedule.sent(at(0.0));
  return schedule;
}

// [MAP-2]
TEST(MapSchedule, BeginsWithTheWholeMap_MAP_2) {
  mapping::MapSchedule schedule;
  EXPECT_FALSE(schedule.note(changed(5), at(0.0))) << "nobody knows what it would be a change of";
  EXPECT_TRUE(schedule.isDue(kCells, at(0.0)));
  EXPECT_TRUE(schedule.sent(at(0.0)));
  EXPECT_FALSE(schedule.isDue(kCells, at(100.0))) << "nothing has changed";
  schedule.reset();
  EXPECT_TRUE(schedule.isDue(kCells, at(100.0)));
}

TEST(MapSchedule, SendsAGrownMapWholeAndNoMoreThanOnceASecond_MAP_2) {
  mapping::MapSchedule schedule = begun();
  EXPECT_FALSE(schedule.note({true, {0, 0, 200, 10}}, at(0.1)));
  EXPECT_FALSE(schedule.note(changed(5), at(0.2))) << "what changes meanwhile goes out with it";
  EXPECT_FALSE(schedule.isDue(kCells, at(0.9)));
  EXPECT_TRUE(schedule.isDue(kCells, at(1.0)));
  EXPECT_TRUE(schedule.sent(at(1.0)));
  EXPECT_TRUE(schedule.note(changed(5), at(1.1)));
}

TEST(MapSchedule, SendsTheWholeMapWhenAsMuchHasChangedAndLaterForLess_MAP_2) {
  mapping::MapSchedule schedule = begun();
  EXPECT_TRUE(schedule.note(changed(130), at(0.5)));
  EXPECT_FALSE(schedule.isDue(kCells, at(4.9)));
  EXPECT_TRUE(schedule.isDue(kCells, at(5.0)));
  EXPECT_TRUE(schedule.note(changed(900), at(0.6)));
  EXPECT_TRUE(schedule.isDue(kCells, at(1.0)));
  EXPECT_FALSE(schedule.sent(at(1.0))) << "it has not grown";
}

TEST(MapSchedule, WaitsWhileThereAreFewChangesButNotForEver_MAP_2) {
  mapping::MapSchedule schedule = begun();
  for (int i = 1; i <= 100; ++i) {
    EXPECT_TRUE(schedule.note(changed(1), at(0.1 * i)));
    EXPECT_FALSE(schedule.isDue(kCells, at(0.1 * i)));
  }
  EXPECT_FALSE(schedule.isDue(kCells, at(14.9)));
  EXPECT_TRUE(schedule.isDue(kCells, at(15.1)));
  schedule.note(changed(1), at(59.0));
  EXPECT_FALSE(schedule.isDue(kCells, at(59.9)));
  EXPECT_TRUE(schedule.isDue(kCells, at(60.0)));
}

TEST(MapSchedule, TellsANewcomerWhatHasChanged_MAP_2) {
  mapping::MapSchedule schedule = begun();
  schedule.noteNewcomer();
  EXPECT_FALSE(schedule.isDue(kCells, at(2.0))) << "the latched map is still true";
  schedule.note(changed(1), at(2.0));
  EXPECT_TRUE(schedule.isDue(kCells, at(2.0)));
}

TEST(MapSchedule, IsNotHeldByAClockThatWasSetBack) { EXPECT_TRUE(begun().isDue(kCells, at(-50.0))); }

}  // namespace
}  // namespace frontier_pilot
