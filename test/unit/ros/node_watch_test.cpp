#include <gtest/gtest.h>

#include "ros/common/clock.h"
#include "ros/common/master/publisher_watch.h"

namespace frontier_pilot {
namespace {

TEST(NodeWatch, FindsOutInALookWhatWasAskedForBefore) {
  int asked = 0;
  NodeWatch watch([&asked](const std::string& node) {
    ++asked;
    return std::optional<bool>(node == "/living");
  });
  const SteadyTime start = steadyNow();
  EXPECT_EQ(watch.lives("/living", start), std::nullopt);
  EXPECT_EQ(watch.lives("/dead", start), std::nullopt);
  EXPECT_EQ(asked, 0) << "who asks does not wait";
  watch.look();
  EXPECT_EQ(watch.lives("/living", start), true);
  EXPECT_EQ(watch.lives("/dead", start), false);
  watch.look();
  EXPECT_EQ(asked, 2) << "what is known is not looked for again";
}

TEST(NodeWatch, FLT_1_SaysNothingOfANodeOfWhichNobodyKnowsUntilSomebodyDoes) {  // [FLT-1]
  std::optional<bool> known;
  NodeWatch watch([&known](const std::string&) { return known; });
  const SteadyTime start = steadyNow();
  for (int looks = 0; looks < 3; ++looks) {
    EXPECT_EQ(watch.lives("/mapper", start), std::nullopt);
    watch.look();
  }
  known = false;
  EXPECT_EQ(watch.lives("/mapper", start), std::nullopt);
  watch.look();
  EXPECT_EQ(watch.lives("/mapper", start), false);
}

TEST(NodeWatch, DoesNotSayWhatWasFoundOutTooEarly) {
  NodeWatch watch([](const std::string&) { return std::optional<bool>(false); });
  watch.lives("/mapper", steadyNow());
  watch.look();
  const SteadyTime later = steadyNow() + std::chrono::hours(1);
  EXPECT_EQ(watch.lives("/mapper", later), std::nullopt);
}

}  // namespace
}  // namespace frontier_pilot
