// Maps are saved although another one is being saved to a disk that hangs. [FLT-1]

#include "ros/common/maps/map_saves.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

#include "ros/common/clock.h"

namespace frontier_pilot {
namespace {

using map_files::MapIoResult;
using map_files::MapIoStatus;

constexpr Duration kVeryLong = std::chrono::seconds(60);

MapIoResult succeed() { return {MapIoStatus::kOk, "saved"}; }

/// In place of the thread of a service: the node ends before it takes up the question.
struct ThreadOfANodeThatEnds {
  template <class Answer>
  std::optional<Answer> ask(const std::function<Answer(int&)>& /*question*/) {
    said_last = saves.whyNotSaved();
    return std::nullopt;
  }
  static std::string whyNot(const std::string& node, const std::string& /*what*/) { return node + " is shut down"; }

  const MapSaves& saves;
  std::string said_last;
};

class MapSavesToADiskThatHangs : public ::testing::Test {
 protected:
  ~MapSavesToADiskThatHangs() override { answer(); }

  std::function<MapIoResult()> hang() {
    return [answered = answered_, begun = begun_] {
      ++*begun;
      answered.wait();
      return succeed();
    };
  }
  /// The disk answers from now on, and what hangs ends.
  void answer() {
    if (!std::exchange(answers_, true)) disk_.set_value();
    while (!saves_.delay(steadyNow() + kVeryLong).empty()) std::this_thread::yield();
  }
  static void mustTell(const std::string& text, const std::string& what) {
    EXPECT_NE(text.find(what), std::string::npos) << text;
  }

  MapSaves saves_{std::chrono::milliseconds(20)};
  std::promise<void> disk_;
  std::shared_future<void> answered_ = disk_.get_future().share();
  std::shared_ptr<std::atomic<int>> begun_ = std::make_shared<std::atomic<int>>(0);
  bool answers_ = false;
};

// [FLT-1]
TEST_F(MapSavesToADiskThatHangs, AreAnsweredInTime_FLT_1) {
  const MapIoResult hung = saves_.run("/hung/floor", hang());
  EXPECT_FALSE(hung.ok());
  mustTell(hung.text, "saving to /hung/floor has not ended");
  EXPECT_EQ(saves_.refusal("/there/floor"), "");
}

// [FLT-1]
TEST_F(MapSavesToADiskThatHangs, DoNotHoldUpThoseToAnotherOne_FLT_1) {
  MapSaves patient(kVeryLong);
  MapIoResult late;
  std::thread caller([&] { late = patient.run("/hung/floor", hang()); });
  while (*begun_ == 0) std::this_thread::yield();
  EXPECT_EQ(patient.run("/there/floor", succeed).text, "saved");
  answer();
  caller.join();
  EXPECT_TRUE(late.ok()) << late.text;
}

// [FLT-1]
TEST_F(MapSavesToADiskThatHangs, AreNotBegunAgainInTheSameFolderUntilItAnswers_FLT_1) {
  saves_.run("/hung/floor", hang());
  const MapIoResult again = saves_.run("/hung/other/../floor_1", [] { return ADD_FAILURE(), succeed(); });
  EXPECT_FALSE(again.ok());
  mustTell(again.text, "saving to /hung/floor has not ended: until it does");
  EXPECT_EQ(saves_.refusal("/hung/floor"), again.text);
  answer();
  EXPECT_EQ(saves_.refusal("/hung/floor"), "");
}

// [FLT-1]
TEST_F(MapSavesToADiskThatHangs, AreFewAtATime_FLT_1) {
  for (std::size_t i = 0; i < MapSaves::kMost; ++i) saves_.run("/hung/" + std::to_string(i) + "/floor", hang());
  const MapIoResult one_more = saves_.run("/there/floor", [] { return ADD_FAILURE(), succeed(); });
  EXPECT_FALSE(one_more.ok());
  mustTell(one_more.text, "saving to /hung/0/floor has not ended");
  answer();
  EXPECT_EQ(saves_.refusal("/there/floor"), "");
}

// [FLT-1]
TEST_F(MapSavesToADiskThatHangs, AreNamedAfterFiveSeconds_FLT_1) {
  saves_.run("/hung/floor", hang());
  EXPECT_EQ(saves_.delay(steadyNow()), "");
  mustTell(saves_.delay(steadyNow() + std::chrono::seconds(47)), "saving to /hung/floor has not ended for 47 s");
  answer();
  EXPECT_EQ(saves_.delay(steadyNow() + kVeryLong), "");
}

// The copy that the mapper keeps for itself is worth something then. [FLT-2]
TEST_F(MapSavesToADiskThatHangs, LeaveTheMapUnsavedUntilALaterOneHasEnded_FLT_2) {
  EXPECT_EQ(saves_.whyNotSaved(), "");
  saves_.run("/hung/floor", hang());
  EXPECT_EQ(saves_.whyNotSaved(), "saving to /hung/floor has not ended");
  answer();
  EXPECT_EQ(saves_.whyNotSaved(), "");
}

// [FLT-2]
TEST_F(MapSavesToADiskThatHangs, LeaveTheMapUnsavedAlsoIfALaterOneWasRefused_FLT_2) {
  saves_.run("/hung/floor", hang());
  const std::string refusal = saves_.run("/hung/floor", succeed).text;
  answer();
  EXPECT_EQ(saves_.whyNotSaved(), refusal) << "what was saved is an earlier map";
  saves_.refuse("the mapper is busy");
  EXPECT_EQ(saves_.whyNotSaved(), "the mapper is busy");
}

// [FLT-1]
TEST_F(MapSavesToADiskThatHangs, ToTheSamePathFollowEachOther_FLT_1) {
  MapSaves patient(kVeryLong);
  std::thread first([&] { patient.run("/slow/floor", hang()); });
  while (*begun_ == 0) std::this_thread::yield();
  std::atomic<bool> second_is_begun = false;
  std::thread second([&] { patient.run("/slow/./floor", [&] { return second_is_begun = true, succeed(); }); });
  EXPECT_TRUE(patient.run("/slow/other", succeed).ok());
  EXPECT_FALSE(second_is_begun);
  answer();
  first.join();
  second.join();
  EXPECT_TRUE(second_is_begun);
}

// [FLT-2]
TEST(MapSaves, LeaveTheMapUnsavedThatCouldNotBeWrittenUntilOneIs_FLT_2) {
  MapSaves saves(kVeryLong);
  saves.run("/full/floor", [] { return MapIoResult{MapIoStatus::kCannotWrite, "the disk is full"}; });
  EXPECT_EQ(saves.whyNotSaved(), "the disk is full");
  saves.run("/full/floor", []() -> MapIoResult { throw std::runtime_error("no memory"); });
  EXPECT_EQ(saves.whyNotSaved(), "no memory");
  EXPECT_TRUE(saves.run("/there/floor", succeed).ok());
  EXPECT_EQ(saves.whyNotSaved(), "");
}

// The node then says its last words, and its copy would be removed. [FLT-2]
TEST(MapSaves, LeaveTheMapUnsavedThatTheNodeHasNotHandedOver_FLT_2) {
  MapSaves saves(kVeryLong);
  ThreadOfANodeThatEnds thread{saves, {}};
  const auto copy = [](const int& map) { return map; };
  const auto save = [](const int&) { return ADD_FAILURE(), succeed(); };
  EXPECT_EQ((saveCopy<int, int>(thread, saves, "/there/floor", "mapper", copy, save).text), "mapper is shut down");
  EXPECT_EQ(thread.said_last, "saving to /there/floor was not begun");
  EXPECT_EQ(saves.whyNotSaved(), "mapper is shut down");
}

// [FLT-2]
TEST(MapSaves, ThatAreBegunWereExpectedInVainNoMore_FLT_2) {
  MapSaves saves(kVeryLong);
  saves.expect("/there/floor");
  EXPECT_TRUE(saves.run("/there/floor", succeed).ok());
  EXPECT_EQ(saves.whyNotSaved(), "");
}

}  // namespace
}  // namespace frontier_pilot
