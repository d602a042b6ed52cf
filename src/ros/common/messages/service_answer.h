#pragma once

#include <exception>
#include <new>
#include <string>
#include <type_traits>

#include "ros/common/callback_guard.h"

namespace frontier_pilot {

/// Whether an answer says in words why a call has failed, in `success` and `message`.
template <class Response, class = void>
struct SaysWhyItFailed : std::false_type {};
template <class Response>
struct SaysWhyItFailed<Response, std::void_t<decltype(Response::success), decltype(Response::message)>>
    : std::true_type {};

/// Lets `handle(request, response)` answer a call. What it throws is counted by `guard` under `what`, and is the reason
/// in the answer, if that has room for one: from roscpp alone the caller would get an error without a reason. Returns
/// false if there is no answer. [FLT-1]
template <class Request, class Response, class F>
bool answerCall(CallbackGuard& guard, const std::string& what, const F& handle, Request& request, Response& response) {
  bool answered = false;
  const auto say = [&](const std::string& why) {
    if constexpr (SaysWhyItFailed<Response>::value) {
      response.success = 0;
      response.message = why;
      answered = true;
    }
  };
  guard.run(what, [&] {
    try {
      answered = handle(request, response);
    } catch (const std::bad_alloc&) {
      say("there is not enough memory");
      throw;
    } catch (const std::exception& error) {
      say(error.what());
      throw;
    }
  });
  return answered;
}

}  // namespace frontier_pilot
