#include "ros/common/threads/patient_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

namespace frontier_pilot {
namespace {

constexpr Duration kLong = std::chrono::seconds(60);
constexpr Duration kShort = std::chrono::milliseconds(20);

/// A job that hangs until it is released.
struct Hanging {
  std::promise<void> release;
  std::shared_future<void> released = release.get_future().share();
  std::function<int()> job() const {
    return [released = released] {
      released.wait();
      return 1;
    };
  }
};

TEST(PatientThread, GivesWhatItsJobsReturn) {
  PatientThread thread(kLong);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(thread.run<int>([i] { return i; }), i);
}

// [FLT-1]
TEST(PatientThread, GivesNothingForAJobThatHangsAndDoesNotWaitForTheNextOnes) {
  PatientThread thread(kShort);
  Hanging hanging;
  EXPECT_FALSE(thread.run<int>(hanging.job()));
  std::atomic<bool> begun{false};
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(thread.run<bool>([&begun] { return begun = true; }));
  EXPECT_FALSE(begun);
  hanging.release.set_value();
  while (!thread.run<int>([] { return 2; })) std::this_thread::yield();
}

// [FLT-1]
TEST(PatientThread, CanBeDestroyedWhileAJobHangs) {
  Hanging hanging;
  {
    PatientThread thread(kShort);
    EXPECT_FALSE(thread.run<int>(hanging.job()));
  }
  hanging.release.set_value();
}

// [FLT-1]
TEST(PatientThread, GivesNothingForAJobThatThrowsAndGoesOn) {
  PatientThread thread(kLong);
  EXPECT_FALSE(thread.run<int>([]() -> int { throw std::runtime_error("no"); }));
  EXPECT_EQ(thread.run<int>([] { return 3; }), 3);
}

TEST(PatientThread, ServesSeveralThreads) {
  PatientThread thread(kLong);
  std::atomic<int> served{0};
  std::vector<std::thread> callers;
  for (int caller = 0; caller < 4; ++caller) {
    callers.emplace_back([&] {
      for (int i = 0; i < 200; ++i) served += thread.run<int>([] { return 1; }).value_or(0);
    });
  }
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(served, 800);
}

}  // namespace
}  // namespace frontier_pilot
