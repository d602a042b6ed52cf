#include "ros/frontier_explorer/clicked_polygon.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

using Click = ClickedPolygon::Click;
constexpr SteadyTime kStart = SteadyTime(std::chrono::hours(1));

// [EXP-10]
TEST(ClickedPolygon, IsClosedByAClickNearItsFirstCorner_EXP_10) {
  ClickedPolygon polygon;
  EXPECT_EQ(polygon.add({0.0, 0.0}, kStart), Click::kCorner);
  EXPECT_EQ(polygon.add({4.0, 0.0}, kStart), Click::kCorner);
  EXPECT_EQ(polygon.add({4.0, 3.0}, kStart), Click::kCorner);
  EXPECT_EQ(polygon.add({0.6, 0.0}, kStart), Click::kCorner) << "more than half a metre away";
  EXPECT_EQ(polygon.add({0.3, 0.4}, kStart), Click::kClosed);
  EXPECT_EQ(polygon.corners().size(), 4U) << "the click that closes it is not a corner";
}

// [EXP-10]
TEST(ClickedPolygon, TwoCornersAreNotClosed_EXP_10) {
  ClickedPolygon polygon;
  polygon.add({0.0, 0.0}, kStart);
  polygon.add({4.0, 0.0}, kStart);
  EXPECT_EQ(polygon.add({0.2, 0.0}, kStart), Click::kCorner);
}

// [EXP-10]
TEST(ClickedPolygon, ADoubleClickIsOneCorner_EXP_10) {
  ClickedPolygon polygon;
  polygon.add({0.0, 0.0}, kStart);
  EXPECT_EQ(polygon.add({0.01, 0.0}, kStart), Click::kSame);
  EXPECT_EQ(polygon.corners().size(), 1U);
}

// [EXP-10]
TEST(ClickedPolygon, IsForgottenHalfAMinuteAfterTheLastClick_EXP_10) {
  ClickedPolygon polygon;
  polygon.add({0.0, 0.0}, kStart);
  polygon.add({4.0, 0.0}, kStart + std::chrono::seconds(29));
  EXPECT_FALSE(polygon.expire(kStart + std::chrono::seconds(58)));
  EXPECT_TRUE(polygon.expire(kStart + std::chrono::seconds(59)));
  EXPECT_TRUE(polygon.corners().empty());
  EXPECT_FALSE(polygon.expire(kStart + std::chrono::seconds(90))) << "only once";
}

// [EXP-10]
TEST(ClickedPolygon, HasNoMoreCornersThanBoundsMayHave_EXP_10) {
  ClickedPolygon polygon;
  for (int i = 0; i < 2000; ++i) ASSERT_EQ(polygon.add({1.0 * i, 0.0}, kStart), Click::kCorner);
  EXPECT_EQ(polygon.add({-5.0, 5.0}, kStart), Click::kTooMany);
}

}  // namespace
}  // namespace frontier_pilot
