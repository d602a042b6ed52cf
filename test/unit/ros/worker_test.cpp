#include "ros/common/threads/worker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

namespace frontier_pilot {
namespace {

/// What `take` gives as soon as it gives something, within ten seconds.
template <class Take>
auto soon(Take take) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  auto value = take();
  while (!value && std::chrono::steady_clock::now() < end) {
    std::this_thread::yield();
    value = take();
  }
  return value;
}

// [FLT-1]
TEST(Worker, TellsWhatAJobThrewAndDoesTheNextOne) {
  Worker<int> worker;
  worker.start([]() -> int { throw std::runtime_error("no memory"); });
  EXPECT_EQ(soon([&] { return worker.takeFailure(); }), "no memory");
  EXPECT_TRUE(worker.idle());
  EXPECT_FALSE(worker.take());
  worker.start([]() -> int { throw 7; });  // NOLINT(hicpp-exception-baseclass): it may be anything
  EXPECT_EQ(soon([&] { return worker.takeFailure(); }), "an exception of unknown type");
  worker.start([] { return 3; });
  EXPECT_EQ(soon([&] { return worker.take(); }), 3);
  EXPECT_FALSE(worker.takeFailure());
  EXPECT_TRUE(worker.idle());
}

TEST(Worker, DoesTheJobThatCameLastWhenThePresentOneHasEnded) {
  Worker<int> worker;
  for (int job = 1; job <= 3; ++job) worker.startNext([job] { return job; });
  EXPECT_EQ(soon([&] { return worker.take(); }), 1);
  EXPECT_FALSE(worker.idle());
  EXPECT_EQ(soon([&] { return worker.take(); }), 3);
  EXPECT_TRUE(worker.idle());
}

}  // namespace
}  // namespace frontier_pilot
