#include "ros/common/messages/mailbox.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

SteadyTime mailAt(double seconds) { return timeFromSeconds<SteadyTime>(seconds); }

TEST(Latest, HasNoAgeBeforeAnythingCame) {
  Latest<int> latest;
  EXPECT_FALSE(latest.age(mailAt(5.0)));
  EXPECT_FALSE(latest.fresh(mailAt(5.0), fromSeconds(100.0)));
}

TEST(Latest, IsFreshUpToItsAgeAndNotBeyond) {
  Latest<int> latest;
  latest.put(7, mailAt(1.0));
  EXPECT_EQ(latest.age(mailAt(1.5)), fromSeconds(0.5));
  EXPECT_EQ(latest.fresh(mailAt(1.5), fromSeconds(0.5)), 7);
  EXPECT_FALSE(latest.fresh(mailAt(1.51), fromSeconds(0.5)));
}

TEST(Mailbox, GivesTheLatestValueOnce) {
  Mailbox<int> mailbox;
  mailbox.put(1);
  mailbox.put(2);
  EXPECT_EQ(mailbox.take(), 2);
  EXPECT_FALSE(mailbox.take());
}

}  // namespace
}  // namespace frontier_pilot
