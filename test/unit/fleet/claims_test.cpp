#include "frontier_pilot/fleet/claims.h"

#include <gtest/gtest.h>

#include <limits>

namespace frontier_pilot {
namespace {

using fleet::ClaimBook;
using fleet::ClaimsMessage;
using fleet::ClaimsVerdict;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ClaimsMessage messageOf(const std::string& robot, const std::vector<exploration::Claim>& claims = {{{1.0, 2.0}, 8.0}}) {
  ClaimsMessage message;
  message.robot = robot;
  message.position = {3.0, 4.0};
  message.claims = claims;
  return message;
}

Time at(double seconds) { return timeFromSeconds(100.0 + seconds); }

// [MUL-2]
TEST(Claims, OfOthersAreKnownInTheRobotsOwnFrameWithTheTimeThatIsLeft_MUL_2) {
  ClaimBook book("robot_2");
  ASSERT_EQ(book.take(messageOf("robot_1"), at(0.0)), ClaimsVerdict::kTaken);
  const Pose2 T_map_common(10.0, 0.0, kPi / 2.0);
  const auto others = book.others(T_map_common, at(3.0));
  ASSERT_EQ(others.size(), 1U);
  EXPECT_EQ(others[0].name, "robot_1");
  EXPECT_TRUE(others[0].precedes);
  EXPECT_NEAR((others[0].position - Vec2(6.0, 3.0)).norm(), 0.0, 1e-9);
  ASSERT_EQ(others[0].claims.size(), 1U);
  EXPECT_NEAR((others[0].claims[0].place - Vec2(8.0, 1.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(others[0].claims[0].cost, 5.0, 1e-9);
}

// [MUL-2]
TEST(Claims, OfARobotThatFallsSilentAreForgottenAfterTenSecondsAndOneThatComesBackTakesPartAgain_MUL_2) {
  ClaimBook book("robot_2");
  book.take(messageOf("robot_1"), at(0.0));
  EXPECT_EQ(book.others({}, at(9.9)).size(), 1U);
  EXPECT_TRUE(book.others({}, at(10.1)).empty());
  EXPECT_EQ(book.take(messageOf("robot_1"), at(60.0)), ClaimsVerdict::kTaken);
  EXPECT_EQ(book.others({}, at(60.0)).size(), 1U);
}

// [MUL-2]
TEST(Claims, AreForgottenAfterTenSecondsWhateverTheirRobotAskedFor_MUL_2) {
  ClaimBook book("robot_2");
  ClaimsMessage lasting = messageOf("robot_1");
  lasting.valid_for = 60.0;
  ASSERT_EQ(book.take(lasting, at(0.0)), ClaimsVerdict::kTaken);
  EXPECT_TRUE(book.others({}, at(10.1)).empty());
}

// [MUL-2]
TEST(Claims, AMessageReplacesTheOneBeforeIt_MUL_2) {
  ClaimBook book("robot_2");
  book.take(messageOf("robot_1"), at(0.0));
  book.take(messageOf("robot_1", {}), at(1.0));
  EXPECT_TRUE(book.others({}, at(1.0))[0].claims.empty());
}

// [MUL-2] [FLT-1]
TEST(Claims, OfAnotherVersionOrWithNonsenseAreRefusedAndWhatWasKnownStays_MUL_2_FLT_1) {
  ClaimBook book("robot_2");
  book.take(messageOf("robot_1"), at(0.0));
  ClaimsMessage bad = messageOf("robot_1");
  bad.version = 2;
  EXPECT_EQ(book.take(bad, at(1.0)), ClaimsVerdict::kOtherVersion);
  bad = messageOf("robot_1", {{{kNan, 0.0}, 1.0}});
  EXPECT_EQ(book.take(bad, at(1.0)), ClaimsVerdict::kMalformed);
  for (const double cost : {kNan, -1.0, 1e9}) {
    EXPECT_EQ(book.take(messageOf("robot_1", {{{0.0, 0.0}, cost}}), at(1.0)), ClaimsVerdict::kMalformed) << cost;
  }
  bad = messageOf("robot_1");
  bad.position.x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(book.take(bad, at(1.0)), ClaimsVerdict::kMalformed);
  for (const double valid_for : {kNan, 0.0, 1e6}) {
    bad = messageOf("robot_1");
    bad.valid_for = valid_for;
    EXPECT_EQ(book.take(bad, at(1.0)), ClaimsVerdict::kMalformed) << valid_for;
  }
  EXPECT_EQ(book.take(messageOf(""), at(1.0)), ClaimsVerdict::kMalformed);
  ASSERT_EQ(book.others({}, at(1.0)).size(), 1U);
  EXPECT_EQ(book.others({}, at(1.0))[0].claims.size(), 1U);
}

// [FLT-1]
TEST(Claims, MoreThanAnyTeamMakesAreRefused_FLT_1) {
  ClaimBook book("robot_2");
  EXPECT_EQ(book.take(messageOf("robot_1", std::vector<exploration::Claim>(41)), at(0.0)), ClaimsVerdict::kTooMany);
  for (int i = 0; i < 100; ++i) book.take(messageOf("x" + std::to_string(i)), at(0.0));
  EXPECT_EQ(book.take(messageOf("one_more"), at(1.0)), ClaimsVerdict::kTooMany);
  EXPECT_EQ(book.take(messageOf("x7"), at(1.0)), ClaimsVerdict::kTaken) << "those that are known are still heard";
  EXPECT_EQ(book.take(messageOf("one_more"), at(12.0)), ClaimsVerdict::kTaken) << "the others have fallen silent";
}

// [MUL-2]
TEST(Claims, ARobotDoesNotTakeItsOwnMessageForAnothers_MUL_2) {
  ClaimBook book("robot_2");
  EXPECT_EQ(book.take(messageOf("robot_2"), at(0.0)), ClaimsVerdict::kOwn);
  EXPECT_TRUE(book.others({}, at(0.0)).empty());
}

// [FLT-1]
TEST(Claims, AreForgottenWhenTheClockJumpsBack_FLT_1) {
  ClaimBook book("robot_2");
  book.take(messageOf("robot_1"), at(0.0));
  EXPECT_TRUE(book.others({}, at(-50.0)).empty());
}

// [MUL-2]
TEST(Claims, AMessageHoldsTheSoonestClaimsInTheCommonFrame_MUL_2) {
  std::vector<exploration::Claim> claims;
  for (int i = 0; i < 60; ++i) claims.push_back({{static_cast<double>(i), 0.0}, 60.0 - i});
  const ClaimsMessage message = fleet::makeClaimsMessage("robot_1", {1.0, 0.0, 0.0}, claims, {0.0, 5.0, 0.0});
  EXPECT_EQ(message.claims.size(), ClaimsMessage::kMostClaims);
  EXPECT_EQ(message.claims.front().place, Vec2(59.0, 5.0));
  EXPECT_EQ(message.claims.front().cost, 1.0);
  EXPECT_EQ(message.position, Vec2(1.0, 5.0));
}

}  // namespace
}  // namespace frontier_pilot
