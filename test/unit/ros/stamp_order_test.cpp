// Which of the stamps of a moving frame are to be believed.

#include "ros/common/tf/stamp_order.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

using Verdict = StampOrder::Verdict;

class StampOrders : public ::testing::Test {
 protected:
  Verdict judge(double stamp, double now, const std::string& child = "base") {
    return order_.judge(child, timeFromSeconds(stamp), timeFromSeconds(now));
  }

  StampOrder order_{std::chrono::seconds(10)};
};

// [FLT-1] One message of the future must not hide every true one until its time has come.
TEST_F(StampOrders, ForgetTheFutureWhenTheNextTrueOneComes) {
  EXPECT_EQ(judge(100.0, 100.0), Verdict::kKeep);
  EXPECT_EQ(judge(9100.0, 100.0), Verdict::kKeep);
  EXPECT_EQ(judge(100.1, 100.1), Verdict::kForgetAndKeep);
  EXPECT_EQ(judge(100.2, 100.2), Verdict::kKeep);
}

// [FLT-1]
TEST_F(StampOrders, RefuseWhatIsOlderThanTheBufferKeeps) {
  EXPECT_EQ(judge(100.0, 100.0), Verdict::kKeep);
  EXPECT_EQ(judge(89.0, 100.0), Verdict::kTooOld);
  EXPECT_EQ(judge(91.0, 100.0), Verdict::kKeep) << "late, but of use";
  EXPECT_EQ(judge(50.0, 100.0, "other"), Verdict::kKeep) << "each frame has a time of its own";
}

// [FLT-1] A second broadcaster, or a relay of /tf, repeats each stamp; tf2 would write two lines for every one of them.
TEST_F(StampOrders, NoticeAStampThatIsRepeated) {
  EXPECT_EQ(judge(100.0, 100.0), Verdict::kKeep);
  EXPECT_EQ(judge(100.1, 100.1), Verdict::kKeep);
  EXPECT_EQ(judge(100.0, 100.1), Verdict::kRepeated) << "a relay may be late";
  EXPECT_EQ(judge(100.1, 100.1), Verdict::kRepeated);
  EXPECT_EQ(judge(100.1, 100.1, "other"), Verdict::kKeep) << "each frame has stamps of its own";
  EXPECT_EQ(judge(9100.0, 100.1), Verdict::kKeep);
  EXPECT_EQ(judge(100.2, 100.2), Verdict::kForgetAndKeep);
  EXPECT_EQ(judge(100.1, 100.2), Verdict::kKeep) << "the buffer has been emptied";
}

// A simulation may be far ahead of a node that hung: what it then hears in order is all of the future.
TEST_F(StampOrders, KeepAFutureThatComesInOrder) {
  for (double stamp = 200.0; stamp < 260.0; stamp += 1.0) EXPECT_EQ(judge(stamp, 100.0), Verdict::kKeep);
  EXPECT_EQ(judge(230.0, 100.0), Verdict::kForgetAndKeep) << "thirty seconds back, and nearer to the clock";
}

// [FLT-1] Stamps that are nanoseconds apart never grow older than the buffer keeps.
TEST_F(StampOrders, StartAnewWithTooManyOfOneFrame_FLT_1) {
  auto next = [this, i = 0]() mutable { return judge(100.0 + 1e-6 * ++i, 100.0); };
  for (std::size_t i = 0; i < StampOrder::kMost; ++i) ASSERT_EQ(next(), Verdict::kKeep);
  EXPECT_EQ(next(), Verdict::kTooMany);
  EXPECT_EQ(next(), Verdict::kKeep);
  EXPECT_EQ(judge(100.0, 100.0, "laser"), Verdict::kKeep) << "of all frames, since the buffer is cleared";
}

}  // namespace
}  // namespace frontier_pilot
