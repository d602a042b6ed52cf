#include "ros/common/inputs/navigation_permission.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

/// An arbiter whose status comes each second, of which a node that depends on the navigation hears.
class NavigationPermissionTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const auto& [name, priority] : {std::pair("avoid", 100), std::pair("nav", 60), std::pair("manual", 40)}) {
      ArbiterSource source;
      source.name = name;
      source.topic = "/cmd_vel_" + source.name;
      source.priority = priority;
      source.enabled = 1;
      status_.sources.push_back(source);
    }
  }
  std::string afterSeconds(int seconds) {
    for (int i = 0; i < seconds; ++i) {
      pass();
      permission_.take(status_, now_, steady_);
    }
    return permission_.refusal(now_, steady_);
  }
  void pass() {
    now_ += std::chrono::seconds(1);
    steady_ += std::chrono::seconds(1);
  }
  void isDrivenBy(const std::string& source) {
    status_.state = source.empty() ? ArbiterStatus::IDLE : ArbiterStatus::DRIVING;
    status_.active_source = source;
  }

  ArbiterStatus status_;
  NavigationPermission permission_{"/cmd_vel_nav"};
  Time now_ = timeFromSeconds(100.0);
  SteadyTime steady_{std::chrono::hours(1)};
};

// [EXP-8] [NAV-5]
TEST_F(NavigationPermissionTest, IsThereWhileTheNavigationOrNobodyOrALesserSourceDrivesAndWithoutAnArbiter) {
  EXPECT_EQ(permission_.refusal(now_, steady_), "");
  for (const char* source : {"", "nav", "manual"}) {
    isDrivenBy(source);
    EXPECT_EQ(afterSeconds(60), "") << source;
  }
}

// [EXP-8] [NAV-5]
TEST_F(NavigationPermissionTest, IsRefusedAtOnceByADisabledSource) {
  status_.sources[1].enabled = 0;
  EXPECT_EQ(afterSeconds(1), "its source nav is disabled");
  status_.sources[1].enabled = 1;
  EXPECT_EQ(afterSeconds(1), "");
}

// [EXP-8] [NAV-5] [ARB-12]
TEST_F(NavigationPermissionTest, IsRefusedWhileNoStopWouldReachTheArbiterButForAMoment) {
  for (const auto state : {ArbiterStatus::CONTESTED, ArbiterStatus::UNREACHABLE}) {
    status_.state = state;
    EXPECT_EQ(afterSeconds(2), "");
    EXPECT_NE(afterSeconds(1), "");
    status_.state = ArbiterStatus::IDLE;
    EXPECT_EQ(afterSeconds(1), "");
  }
}

// [EXP-8] [NAV-5] [ARB-4]
TEST_F(NavigationPermissionTest, IsRefusedWhileARequiredSourceOfHigherPriorityIsSilent) {
  status_.missing_sources = {"manual"};
  EXPECT_EQ(afterSeconds(60), "");
  status_.missing_sources = {"avoid"};
  EXPECT_EQ(afterSeconds(3), "its source avoid is required but silent");
}

// [EXP-8] [NAV-5]
TEST_F(NavigationPermissionTest, IsNotRefusedByTheRecoveriesOfTheAvoiderButByOneThatDoesNotEnd) {
  for (int recovery = 0; recovery < 10; ++recovery) {
    isDrivenBy("avoid");
    EXPECT_EQ(afterSeconds(15), "");
    isDrivenBy("nav");
    EXPECT_EQ(afterSeconds(1), "");
  }
  isDrivenBy("avoid");
  EXPECT_EQ(afterSeconds(21), "its source avoid has the wheels");
  isDrivenBy("nav");
  EXPECT_EQ(afterSeconds(1), "");
}

TEST_F(NavigationPermissionTest, IsNotRefusedForEverByAnArbiterThatHasFallenSilentNorByAnotherRobots) {
  status_.sources[1].enabled = 0;
  ASSERT_NE(afterSeconds(1), "");
  for (int i = 0; i < 6; ++i) pass();
  EXPECT_EQ(permission_.refusal(now_, steady_), "");
  for (ArbiterSource& source : status_.sources) source.topic = "/other" + source.topic;
  EXPECT_EQ(afterSeconds(1), "");
}

}  // namespace
}  // namespace frontier_pilot
