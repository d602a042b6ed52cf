#include "ros/cmd_vel_arbiter/stop_listeners.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

constexpr SteadyTime kBegun{std::chrono::hours(1)};

// [ARB-8] [FLT-2]
TEST(StopListeners, AreAwaitedUntilAllThatTheMasterListsAreConnected_ARB_8_FLT_2) {
  StopListeners listeners("/arbiter");
  listeners.begin(kBegun);
  EXPECT_TRUE(listeners.areAwaited(kBegun)) << "the master has not been asked yet";
  listeners.list({"/arbiter", "/navigator", "/explorer"});
  EXPECT_TRUE(listeners.areAwaited(kBegun));
  listeners.connect("/navigator");
  listeners.connect("/navigator");
  EXPECT_TRUE(listeners.areAwaited(kBegun));
  listeners.connect("/explorer");
  EXPECT_FALSE(listeners.areAwaited(kBegun));
  listeners.disconnect("/navigator");
  EXPECT_FALSE(listeners.areAwaited(kBegun)) << "the other connection is there";
  listeners.disconnect("/navigator");
  listeners.disconnect("/nobody");
  EXPECT_TRUE(listeners.areAwaited(kBegun));
}

// [FLT-2]
TEST(StopListeners, AreNotAwaitedForEverIfOneHangs_FLT_2) {
  StopListeners listeners("/arbiter");
  listeners.begin(kBegun);
  listeners.list({"/hangs"});
  EXPECT_TRUE(listeners.areAwaited(kBegun + std::chrono::seconds(9)));
  EXPECT_FALSE(listeners.areAwaited(kBegun + std::chrono::seconds(10)));
}

}  // namespace
}  // namespace frontier_pilot
