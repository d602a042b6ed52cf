#include "ros/common/messages/service_answer.h"

#include <gtest/gtest.h>
#include <nav_msgs/GetMap.h>
#include <std_srvs/Trigger.h>

#include <new>
#include <stdexcept>

namespace frontier_pilot {
namespace {

using Request = std_srvs::Trigger::Request;
using Response = std_srvs::Trigger::Response;

struct Answer {
  bool given = false;
  Response response;
};

template <class F>
Answer answerOf(CallbackGuard& guard, const F& handle) {
  Request request;
  Answer answer;
  answer.given = answerCall(guard, "a request to load", handle, request, answer.response);
  return answer;
}

// [FLT-1]
TEST(ServiceAnswer, IsWhatTheServiceSays) {
  CallbackGuard guard;
  const Answer answer = answerOf(guard, [](Request&, Response& response) { return response.success = 1; });
  EXPECT_TRUE(answer.given && answer.response.success);
  EXPECT_FALSE(answerOf(guard, [](Request&, Response&) { return false; }).given);
  EXPECT_EQ(guard.total(), 0U);
}

// [FLT-1]
TEST(ServiceAnswer, SaysWhyTheServiceHasFailedWhenItThrows_FLT_1) {
  CallbackGuard guard;
  const Answer refused = answerOf(guard, [](Request&, Response& response) -> bool {
    response.success = 1;
    throw std::runtime_error("the disk is full");
  });
  EXPECT_TRUE(refused.given);
  EXPECT_FALSE(refused.response.success);
  EXPECT_EQ(refused.response.message, "the disk is full");
  const Answer large = answerOf(guard, [](Request&, Response&) -> bool { throw std::bad_alloc(); });
  EXPECT_TRUE(large.given);
  EXPECT_EQ(large.response.message, "there is not enough memory");
  EXPECT_EQ(guard.total(), 2U);
}

// [FLT-1]
TEST(ServiceAnswer, IsMissingWhereItHasNoRoomForAReason_FLT_1) {
  CallbackGuard guard;
  nav_msgs::GetMap::Request request;
  nav_msgs::GetMap::Response response;
  const auto fail = [](auto&, auto&) -> bool { throw std::runtime_error("no map yet"); };
  EXPECT_FALSE(answerCall(guard, "a request for the map", fail, request, response));
  EXPECT_EQ(guard.total(), 1U);
}

}  // namespace
}  // namespace frontier_pilot
