#include "ros/common/threads/questions.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <thread>

namespace frontier_pilot {
namespace {

constexpr Duration kPatient = std::chrono::seconds(60);
constexpr Duration kImpatient = std::chrono::milliseconds(20);

/// A thread that owns a number and answers until it is destroyed.
class NumberOwner {
 public:
  explicit NumberOwner(Questions<int>& questions)
      : thread_([this, &questions] {
          while (!ending_) answer(questions);
        }) {}
  ~NumberOwner() {
    ending_ = true;
    thread_.join();
  }

 private:
  void answer(Questions<int>& questions) {
    try {
      questions.answer(number_);
    } catch (const std::runtime_error&) {
    }
    std::this_thread::yield();
  }

  int number_ = 1;
  std::atomic<bool> ending_{false};
  std::thread thread_;  ///< the last member: all others exist while it runs
};

TEST(Questions, AreAnsweredByTheThreadThatOwnsTheSubject) {
  Questions<int> questions(kPatient);
  const NumberOwner owner(questions);
  EXPECT_EQ(questions.ask<int>([](int& number) { return number++; }), 1);
  EXPECT_EQ(questions.ask<int>([](int& number) { return number; }), 2);
}

// [MAP-5] what a question has changed must not be denied
TEST(Questions, ThatWereTakenUpInTimeAreWaitedForHoweverLongTheyTake_MAP_5) {
  Questions<int> questions(kImpatient);
  const NumberOwner owner(questions);
  std::atomic<bool> begun{false};
  std::optional<bool> answer;
  while (!begun) {  // a busy computer may not take it up in time
    answer = questions.ask<bool>([&begun](int&) {
      begun = true;
      std::this_thread::sleep_for(5 * kImpatient);
      return true;
    });
  }
  EXPECT_TRUE(answer);
}

TEST(Questions, ThatNobodyTakesUpAreWithdrawn) {
  Questions<int> questions(kImpatient);
  int number = 1;
  EXPECT_FALSE(questions.ask<int>([](int& it) { return it = 2; }));
  questions.answer(number);
  EXPECT_EQ(number, 1);
}

// [FLT-1]
TEST(Questions, ThatThrowAreNotAnswered) {
  Questions<int> questions(kPatient);
  const NumberOwner owner(questions);
  EXPECT_FALSE(questions.ask<int>([](int&) -> int { throw std::runtime_error("no"); }));
  EXPECT_EQ(questions.ask<int>([](int& number) { return number; }), 1);
}

TEST(Questions, AreNotAskedAnyMoreOnceClosed) {
  Questions<int> questions(kPatient);
  std::thread closing([&] { questions.close(); });
  EXPECT_FALSE(questions.ask<int>([](int& number) { return number; }));
  closing.join();
  EXPECT_TRUE(questions.closed());
  EXPECT_FALSE(questions.ask<int>([](int& number) { return number; }));
}

}  // namespace
}  // namespace frontier_pilot
