// The copy of the map that a mapper leaves for the one that is started in its place. [FLT-2]

#include "ros/mapper/map_autosave.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <future>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "frontier_pilot/occupancy/scan_inserter.h"
#include "ros/common/memory/disk.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

const Pose2 kThere(1.0, 2.0, 0.5);  // of odometry, on the first map

class MapAutosaveInASession : public ::testing::Test {
 protected:
  MapAutosaveInASession() {
    setenv("ROS_HOME", home_.path().c_str(), 1);
    setenv("XDG_RUNTIME_DIR", in_memory_.path().c_str(), 1);
    setDiskPatience(std::chrono::seconds(20));
    autosave_.emplace("");
    autosave_->enter({"session"});
  }
  ~MapAutosaveInASession() override {
    unsetenv("ROS_HOME");
    unsetenv("XDG_RUNTIME_DIR");
  }

  /// A map with one known cell.
  static occupancy::OccupancyMap mapAt(double x) {
    occupancy::OccupancyMap map;
    map.reserve({x, 0.0}, {x + 1.0, 1.0});
    map.beginScan();
    map.hit({0, 0});
    return map;
  }
  /// The disk is busy until the promise is kept.
  static std::promise<void> keepTheDiskBusy() {
    setDiskPatience(std::chrono::milliseconds(50));
    std::promise<void> end;
    diskThread().run<int>([busy = end.get_future().share()] { return busy.wait(), 0; });
    return end;
  }
  /// Another map is loaded in place of the one that is kept, while the disk is busy until the promise is kept.
  std::promise<void> loadWhileTheDiskIsBusy() {
    EXPECT_EQ(save(mapAt(0.0), {kThere, true}), "");
    autosave_->supersede();
    return keepTheDiskBusy();
  }
  /// `job` is done while the disk is busy for a moment.
  static void onABusyDisk(std::promise<void> end, const std::function<void()>& job) {
    std::thread disk([&end] {
      std::this_thread::sleep_for(std::chrono::milliseconds(200));
      end.set_value();
    });
    job();
    disk.join();
  }
  /// The map is saved from now on, and is not before what stays in `hanging_` is run.
  void beginToSave(double x, const MapPose& pose, std::uint64_t rendered) {
    occupancy::OccupancyMap map = mapAt(x);
    autosave_->save(map, pose, {++scans_, rendered},
                    [this](std::function<void()> job) { hanging_.push_back(std::move(job)); });
  }
  std::string save(occupancy::OccupancyMap map, const MapPose& pose) {
    autosave_->save(map, pose, {++scans_, 0}, [](const std::function<void()>& job) { job(); });
    return autosave_->whyNotSaved();
  }
  /// Another map is loaded in place of the one that is kept, while the disk hangs: what is to be written there stays
  /// in `hanging_`. Returns why the loaded map would not survive.
  std::string loadWhileTheDiskHangs(double x) {
    autosave_->supersede();
    beginToSave(x, {Pose2(), false}, 0);
    return autosave_->whyNotSaved();
  }
  /// Nothing can be removed from the disk any more, nor written there.
  void lockTheDisk() const {
    std::filesystem::rename(session_, away_);
    std::ofstream(session_.string()) << "a file";
  }
  void unlockTheDisk() const {
    std::filesystem::remove(session_);
    std::filesystem::rename(away_, session_);
  }
  /// What a mapper continues with that is started now.
  std::optional<MapPose> restored() {
    MapAutosave next("");
    next.enter({"session"});
    occupancy::OccupancyMap map;
    return next.restore(map);
  }

  const test::TemporaryFolder home_, in_memory_;
  const std::filesystem::path session_ = home_.path() / "frontier_pilot" / "session", away_ = home_.path() / "away";
  std::optional<MapAutosave> autosave_;
  std::vector<std::function<void()>> hanging_;
  std::uint64_t scans_ = 0;
};

// [FLT-2]
TEST_F(MapAutosaveInASession, IsContinuedWithAtTheSamePlace_FLT_2) {
  EXPECT_EQ(save(mapAt(0.0), {kThere, true}), "");
  const auto pose = restored();
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->T_map_odom, kThere);
  EXPECT_TRUE(pose->localized);
}

// Odometry may be reset, or the robot be found, while a large map is written. [FLT-2]
TEST_F(MapAutosaveInASession, IsContinuedWithAtThePlaceThatBecameKnownWhileItWasSaved_FLT_2) {
  const Pose2 later(3.0, 4.0, -0.5), on_the_next_map(5.0, 6.0, 0.0);
  beginToSave(0.0, {kThere, false}, 1);
  autosave_->remember({later, true}, 1);
  autosave_->remember({on_the_next_map, true}, 2);
  hanging_.front()();
  const auto pose = restored();
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->T_map_odom, later);
  EXPECT_TRUE(pose->localized);
}

// [FLT-2] [MAP-5]
TEST_F(MapAutosaveInASession, OfAMapThatWasLoadedIsNotContinuedWithAtThePlaceOnTheMapBefore_FLT_2_MAP_5) {
  std::promise<void> end = loadWhileTheDiskIsBusy();
  EXPECT_NE(save(mapAt(5.0), {Pose2(), false}), "") << "the pose could not be written";
  end.set_value();
  EXPECT_THROW(restored(), std::runtime_error) << "neither map is there beside that pose";
}

// [FLT-2] [MAP-5]
TEST_F(MapAutosaveInASession, OfAMapThatWasLoadedIsThereAlsoIfTheDiskIsBusyForAMoment_FLT_2_MAP_5) {
  onABusyDisk(loadWhileTheDiskIsBusy(), [this] { EXPECT_EQ(save(mapAt(5.0), {Pose2(), false}), ""); });
  const auto pose = restored();
  ASSERT_TRUE(pose);
  EXPECT_FALSE(pose->localized);
}

// [FLT-2] [MAP-5]
TEST_F(MapAutosaveInASession, IsContinuedWithAlsoIfTheDiskIsBusyForAMomentWhenItsPoseIsWritten_FLT_2_MAP_5) {
  beginToSave(0.0, {kThere, true}, 0);
  onABusyDisk(keepTheDiskBusy(), [this] { hanging_.front()(); });
  EXPECT_EQ(autosave_->whyNotSaved(), "");
  const auto pose = restored();
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->T_map_odom, kThere);
}

// [FLT-2]
TEST_F(MapAutosaveInASession, IsContinuedWithUntilItIsSaidThatAnotherMapWasLoaded_FLT_2) {
  EXPECT_EQ(save(mapAt(0.0), {kThere, true}), "");
  autosave_->supersede();
  EXPECT_TRUE(restored()) << "one of the two maps";
}

// [FLT-2] [MAP-5]
TEST_F(MapAutosaveInASession, OfAMapThatWasReplacedWhileTheDiskHangsIsNotContinuedWith_FLT_2_MAP_5) {
  EXPECT_EQ(save(mapAt(0.0), {kThere, true}), "");
  EXPECT_EQ(loadWhileTheDiskHangs(5.0), "it is still being saved");
  EXPECT_THROW(restored(), std::runtime_error) << "the disk has only the map of before";
  hanging_.front()();
  EXPECT_TRUE(restored()) << "the map that was loaded";
  EXPECT_EQ(autosave_->whyNotSaved(), "");
  EXPECT_TRUE(restored());
}

// [FLT-2] [MAP-5]
TEST_F(MapAutosaveInASession, OfAMapThatWasReplacedIsPutAsideByTheNextMapper_FLT_2_MAP_5) {
  EXPECT_EQ(save(mapAt(0.0), {kThere, true}), "");
  loadWhileTheDiskHangs(5.0);
  MapAutosave next("");
  next.enter({"session"});
  occupancy::OccupancyMap map;
  try {
    next.restore(map);
    FAIL() << "it is of the map of before";
  } catch (const std::runtime_error& error) {
    next.lose(error.what());
  }
  EXPECT_NE(next.loss().find("/lost/"), std::string::npos) << next.loss();
}

// [FLT-2] [MAP-5]
TEST_F(MapAutosaveInASession, OfTheFirstOfTwoMapsThatWereLoadedWhileTheDiskHangsIsNotContinuedWith_FLT_2_MAP_5) {
  EXPECT_EQ(save(mapAt(0.0), {kThere, true}), "");
  loadWhileTheDiskHangs(5.0);
  EXPECT_EQ(loadWhileTheDiskHangs(9.0), "it is still being saved");
  ASSERT_EQ(hanging_.size(), 1U) << "one save at a time";
  hanging_.front()();
  EXPECT_EQ(autosave_->whyNotSaved(), "it is still being saved") << "that was the first one";
  EXPECT_THROW(restored(), std::runtime_error);
}

// The mapper ends before a large copy is written, which nobody is to go on with unasked. [FLT-2] [MAP-5]
TEST_F(MapAutosaveInASession, ThatIsLeftWhileItIsBeingWrittenIsNamedAndNotContinuedWith_FLT_2_MAP_5) {
  EXPECT_EQ(save(mapAt(0.0), {kThere, true}), "");
  beginToSave(5.0, {kThere, true}, 0);
  autosave_->hurry();
  beginToSave(9.0, {kThere, true}, 0);
  ASSERT_EQ(hanging_.size(), 1U) << "one save at a time";
  const auto left = autosave_->leave(std::chrono::seconds(20));
  ASSERT_TRUE(left);
  EXPECT_TRUE(left->is_being_written);
  EXPECT_THROW(restored(), std::runtime_error);
  hanging_.front()();
  EXPECT_TRUE(kept_map::exists(left->base));
  EXPECT_THROW(restored(), std::runtime_error) << "the save has taken the mark back";
}

// [FLT-2]
TEST_F(MapAutosaveInASession, ThatIsLeftAfterItWasWrittenIsPutAside_FLT_2) {
  beginToSave(5.0, {kThere, true}, 0);
  hanging_.front()();
  const auto left = autosave_->leave(std::chrono::seconds(20));
  ASSERT_TRUE(left);
  EXPECT_FALSE(left->is_being_written);
  EXPECT_NE(left->base.find("/lost/"), std::string::npos) << left->base;
  EXPECT_TRUE(kept_map::exists(left->base));
  EXPECT_FALSE(restored());
}

// [FLT-2]
TEST_F(MapAutosaveInASession, OfAMapThatWasResetIsNotContinuedWithAlthoughItCannotBeRemoved_FLT_2) {
  EXPECT_EQ(save(mapAt(0.0), {kThere, true}), "");
  lockTheDisk();
  EXPECT_EQ(autosave_->forget(), "");
  EXPECT_FALSE(autosave_->isForgetting());
  unlockTheDisk();
  EXPECT_THROW(restored(), std::runtime_error);
  EXPECT_EQ(save(mapAt(5.0), {Pose2(), true}), "");
  EXPECT_TRUE(restored()) << "the map since";
}

// [FLT-2]
TEST_F(MapAutosaveInASession, OfAMapThatWasResetAndCannotBeRemovedWouldComeBackWithoutAPlaceInMemoryWhichIsSaid_FLT_2) {
  setenv("XDG_RUNTIME_DIR", "/dev/null/none", 1);
  autosave_.emplace("");
  autosave_->enter({"session"});
  EXPECT_EQ(save(mapAt(0.0), {kThere, true}), "");
  lockTheDisk();
  EXPECT_EQ(autosave_->forget(), "the previous map would come back");
}

// [FLT-2] [MAP-5]
TEST_F(MapAutosaveInASession, OfAMapThatWasReplacedWouldComeBackWithoutAPlaceInMemoryWhichIsSaid_FLT_2_MAP_5) {
  setenv("XDG_RUNTIME_DIR", "/dev/null/none", 1);
  autosave_.emplace("");
  autosave_->enter({"session"});
  EXPECT_EQ(save(mapAt(0.0), {kThere, true}), "");
  EXPECT_EQ(loadWhileTheDiskHangs(5.0), "it is still being saved; the previous map would come back");
}

}  // namespace
}  // namespace frontier_pilot
