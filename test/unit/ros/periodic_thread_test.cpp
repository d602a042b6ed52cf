#include "ros/common/threads/periodic_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>

namespace frontier_pilot {
namespace {

constexpr Duration kPeriod = std::chrono::milliseconds(1);

void waitUntil(const std::atomic<int>& count, int least) {
  while (count < least) std::this_thread::yield();
}

TEST(PeriodicThread, CallsEachOfItsFunctionsAgainAndAgainAlsoBesideOneThatThrows) {
  std::atomic<int> first{0}, second{0};
  PeriodicThread thread(kPeriod);
  thread.add([&first] { ++first; });
  thread.add([] { throw std::runtime_error("no"); });
  thread.add([&second] { ++second; });
  waitUntil(first, 5);
  waitUntil(second, 5);
}

// [ARB-10] What waits for a slow disk holds up nobody.
TEST(PeriodicThread, AFunctionThatHangsHoldsUpNeitherWhoAddsNorWhoRemovesAnother) {
  std::promise<void> release;
  std::shared_future<void> released = release.get_future().share();
  std::atomic<int> hanging{0};
  PeriodicThread thread(kPeriod);
  thread.add([&hanging, released] {
    ++hanging;
    released.wait();
  });
  waitUntil(hanging, 1);
  thread.remove(thread.add([] {}));
  release.set_value();
}

TEST(PeriodicThread, AFunctionThatWasRemovedIsNotCalledAnyMore) {
  std::atomic<int> removed{0}, other{0};
  PeriodicThread thread(kPeriod);
  const int number = thread.add([&removed] { ++removed; });
  thread.add([&other] { ++other; });
  waitUntil(removed, 3);
  thread.remove(number);
  const int calls = removed;
  waitUntil(other, other + 5);
  EXPECT_EQ(removed, calls);
}

}  // namespace
}  // namespace frontier_pilot
