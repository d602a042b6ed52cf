#include "frontier_pilot/sim/real_time_pacer.h"

#include <gtest/gtest.h>

#include <limits>

namespace frontier_pilot::sim {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(10);

SteadyTime at(double seconds) { return timeFromSeconds<SteadyTime>(100.0 + seconds); }

std::int64_t run(RealTimePacer& pace, double from, double to) {
  std::int64_t steps = 0;
  for (double t = from; t < to; t += 0.003) {
    for (std::int64_t due = pace.due(at(t)); due > 0; --due, ++steps) pace.stepped();
  }
  return steps;
}

// [SIM-4] speed scales time
TEST(RealTimePacer, KeepsSimulatedTimeInProportionToRealTime_SIM_4) {
  for (double speed : {0.5, 1.0, 4.0, 20.0}) {
    RealTimePacer pace(speed, kStep);
    EXPECT_NEAR(static_cast<double>(run(pace, 0.0, 10.0)), 1000.0 * speed, speed + 1.0);
    EXPECT_EQ(pace.timesBehind(), 0);
  }
}

// [SIM-4] speed 0 runs as fast as it can
TEST(RealTimePacer, NeverEndsWithoutASpeed_SIM_4) {
  RealTimePacer pace(0.0, kStep);
  EXPECT_EQ(pace.due(at(0.0)), std::numeric_limits<std::int64_t>::max());
}

// [SIM-4] pause holds everything: nothing is made up for afterwards
TEST(RealTimePacer, OwesNothingForARest_SIM_4) {
  RealTimePacer pace(1.0, kStep);
  run(pace, 0.0, 1.0);
  pace.rest();
  EXPECT_EQ(pace.due(at(500.0)), 0);
  EXPECT_EQ(pace.due(at(500.02)), 2);
  EXPECT_EQ(pace.timesBehind(), 0);
}

TEST(RealTimePacer, ForgivesWhatItCannotKeepUpWith_SIM_4) {
  RealTimePacer pace(1.0, kStep);
  EXPECT_EQ(pace.due(at(0.0)), 0);
  EXPECT_EQ(pace.due(at(0.2)), 0);
  EXPECT_EQ(pace.due(at(0.225)), 22);
  EXPECT_EQ(pace.due(at(3.0)), 0);
  EXPECT_EQ(pace.due(at(3.025)), 0);
  EXPECT_EQ(pace.timesBehind(), 1);
  EXPECT_EQ(pace.due(at(3.045)), 2);
}

// [SIM-4, ARB-7] what was sent while the simulation was held up is read before it is caught up
TEST(RealTimePacer, OwesNothingForAMomentAfterItWasHeldUp_SIM_4_ARB_7) {
  for (double speed : {0.0, 1.0, 10.0}) {
    RealTimePacer pace(speed, kStep);
    pace.due(at(0.0));
    EXPECT_GT(pace.due(at(0.02)), 0) << speed;
    for (double t : {0.22, 0.225, 0.235}) EXPECT_EQ(pace.due(at(t)), 0) << speed;
    EXPECT_GE(pace.due(at(0.245)), 20 * static_cast<std::int64_t>(speed)) << speed;
  }
}

TEST(RealTimePacer, CatchesUpOnAComputerThatIsAlwaysLate_SIM_4) {
  RealTimePacer pace(1.0, kStep);
  std::int64_t steps = 0;
  for (double t = 0.0; t < 10.0; t += 0.1) {
    for (std::int64_t due = pace.due(at(t)); due > 0; --due, ++steps) pace.stepped();
  }
  EXPECT_NEAR(static_cast<double>(steps), 1000.0, 21.0);
  EXPECT_EQ(pace.timesBehind(), 0);
}

}  // namespace
}  // namespace frontier_pilot::sim
