#include "ros/common/maps/map_owner.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

SteadyTime ownersTime(double seconds) { return SteadyTime{} + fromSeconds(seconds); }

MapOwner heardAtTheStart() {
  MapOwner owner;
  owner.hear("/mapper", ownersTime(0.0));
  return owner;
}

/// What is found out about a node, whatever its name.
MapOwner::Question always(std::optional<bool> found) {
  return [found](const std::string&, SteadyTime) { return found; };
}

TEST(MapOwner, FLT_1_IsAskedAboutByItsNameOnceItWasSilentForFiveSeconds) {  // [FLT-1]
  MapOwner owner = heardAtTheStart();
  int asked = 0;
  const MapOwner::Question question = [&asked](const std::string& node, SteadyTime since) {
    EXPECT_EQ(node, "/mapper");
    EXPECT_EQ(since, ownersTime(5.0)) << "what was found out before does not count";
    ++asked;
    return std::optional<bool>(true);
  };
  EXPECT_TRUE(owner.lives(ownersTime(4.9), question));
  EXPECT_EQ(asked, 0);
  EXPECT_TRUE(owner.lives(ownersTime(6.0), question));
  EXPECT_TRUE(owner.lives(ownersTime(10.9), question));
  EXPECT_EQ(asked, 1) << "nor again within five seconds";
}

TEST(MapOwner, FLT_1_LivesAsLongAsNobodyKnowsWhetherItDoes) {  // [FLT-1]
  MapOwner owner = heardAtTheStart();
  for (const double seconds : {6.0, 60.0, 3600.0})
    EXPECT_TRUE(owner.lives(ownersTime(seconds), always(std::nullopt))) << seconds;
  EXPECT_FALSE(owner.lives(ownersTime(3601.0), always(false)));
}

TEST(MapOwner, FLT_1_ThatWasFoundDeadIsSoUntilItIsHeardAgain) {  // [FLT-1]
  MapOwner owner = heardAtTheStart();
  EXPECT_FALSE(owner.lives(ownersTime(6.0), always(false)));
  EXPECT_FALSE(owner.lives(ownersTime(60.0), always(std::nullopt)));
  owner.hear("/mapper", ownersTime(61.0));
  EXPECT_TRUE(owner.lives(ownersTime(67.0), always(std::nullopt)));
}

}  // namespace
}  // namespace frontier_pilot
