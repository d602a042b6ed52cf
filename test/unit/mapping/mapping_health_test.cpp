// What is worth the operator's attention. [MAP-4]

#include <gtest/gtest.h>

#include "mapping/mapping_health.h"

namespace frontier_pilot {
namespace {

class MappingHealthTest : public ::testing::Test {
 protected:
  void add(int scans, const char* remark) {
    for (int i = 0; i < scans; ++i) health.add(now += std::chrono::milliseconds(100), remark);
  }

  Time now = timeFromSeconds(100.0);
  mapping::MappingHealth health;
};

TEST_F(MappingHealthTest, NamesWhatIsWrongMostOftenAndHowOften) {
  add(20, nullptr);
  add(12, "stale");
  add(8, "no odometry");
  ASSERT_TRUE(health.worst(now));
  EXPECT_EQ(health.worst(now)->text, "stale");
  EXPECT_DOUBLE_EQ(health.worst(now)->share, 0.3);
}

TEST_F(MappingHealthTest, ASlipIsNotWorthARemark) {
  add(2, "stale");
  EXPECT_FALSE(health.worst(now));
  add(47, nullptr);
  add(1, "stale");
  EXPECT_FALSE(health.worst(now)) << "three of fifty";
}

TEST_F(MappingHealthTest, ForgetsAfterFiveSecondsEvenIfNoScanComes) {
  add(10, "stale");
  EXPECT_TRUE(health.worst(now));
  EXPECT_FALSE(health.worst(now + std::chrono::seconds(6)));
}

TEST_F(MappingHealthTest, BeginsAnewWhenTheClockIsSetBack) {
  add(10, "stale");
  now = timeFromSeconds(50.0);
  add(10, nullptr);
  EXPECT_FALSE(health.worst(now));
}

// [FLT-1] As while ROS time stands still.
TEST_F(MappingHealthTest, FLT_1_RemembersABoundedNumberOfScansOfOneStamp) {
  for (int i = 0; i < 100'000; ++i) health.add(now, "stale");
  for (int i = 0; i < 1000; ++i) health.add(now, nullptr);
  EXPECT_FALSE(health.worst(now)) << "they are all forgotten";
}

}  // namespace
}  // namespace frontier_pilot
