#include "ros/fleet_stop/known_robots.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

const SteadyTime kFirstSeen{};

// [MUL-4]
TEST(KnownRobots, ForgetARobotThatNobodyListedAnHourAfterItWasSeenLast_MUL_4) {
  KnownRobots robots;
  robots.see("/robot1/emergency_stop", kFirstSeen);
  robots.see("/robot2/emergency_stop", kFirstSeen);
  robots.see("/robot1/emergency_stop", kFirstSeen + std::chrono::minutes(30));
  EXPECT_EQ(robots.forget(kFirstSeen + std::chrono::minutes(59)), std::vector<std::string>());
  EXPECT_EQ(robots.forget(kFirstSeen + std::chrono::minutes(61)), std::vector<std::string>{"/robot2/emergency_stop"});
  EXPECT_EQ(robots.forget(kFirstSeen + std::chrono::minutes(62)), std::vector<std::string>()) << "it is forgotten once";
  EXPECT_EQ(robots.forget(kFirstSeen + std::chrono::minutes(91)), std::vector<std::string>{"/robot1/emergency_stop"});
}

// [MUL-4] An answer that all have stopped may not leave out a robot that the operator has listed.
TEST(KnownRobots, NeverForgetARobotThatIsListed_MUL_4) {
  KnownRobots robots;
  robots.list("/robot1/emergency_stop");
  robots.see("/robot1/emergency_stop", kFirstSeen);
  EXPECT_EQ(robots.forget(kFirstSeen + std::chrono::hours(1000)), std::vector<std::string>());
}

// [MUL-4]
TEST(KnownRobots, KnowARobotAgainThatHasComeBack_MUL_4) {
  KnownRobots robots;
  robots.see("/robot1/emergency_stop", kFirstSeen);
  robots.forget(kFirstSeen + std::chrono::minutes(61));
  robots.see("/robot1/emergency_stop", kFirstSeen + std::chrono::minutes(100));
  EXPECT_EQ(robots.forget(kFirstSeen + std::chrono::minutes(150)), std::vector<std::string>());
  EXPECT_EQ(robots.forget(kFirstSeen + std::chrono::minutes(161)), std::vector<std::string>{"/robot1/emergency_stop"});
}

}  // namespace
}  // namespace frontier_pilot
