// Who keeps something in a ROS session hears of its names, however late the master tells them.
#include "ros/common/master/session_news.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

using Sessions = SessionNews::Sessions;

// [FLT-2]
TEST(SessionNews, AsksAgainUntilTheMasterTellsAName_FLT_2) {
  Sessions answer;
  std::vector<Sessions> told;
  SessionNews news([&] { return answer; });
  news.add([&](const Sessions& sessions) { told.push_back(sessions); });
  news.tell();
  EXPECT_TRUE(told.empty()) << "a session without a name is none";
  answer = {"run", "master"};
  news.tell();
  news.tell();
  EXPECT_EQ(told, std::vector<Sessions>{answer}) << "once";
}

// [FLT-2]
TEST(SessionNews, IsToldAgainAfterARenewalAndToWhoeverComesLater_FLT_2) {
  Sessions answer{"run"};
  int first = 0, second = 0;
  SessionNews news([&] { return answer; });
  news.add([&](const Sessions&) { ++first; });
  news.tell();
  answer.clear();
  news.renew();
  news.tell();
  EXPECT_EQ(first, 1) << "the new master hangs";
  answer = {"another run"};
  news.tell();
  EXPECT_EQ(first, 2);
  news.add([&](const Sessions&) { ++second; });
  news.tell();
  EXPECT_EQ(second, 1);
}

}  // namespace
}  // namespace frontier_pilot
