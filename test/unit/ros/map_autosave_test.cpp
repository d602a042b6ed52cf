// The copy of the map that a mapper leaves for the one that is started in its place. [FLT-2]

#include "ros/mapper/map_autosave.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>

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
    setDiskPatience(std::chrono::seconds(20));
    autosave_.emplace("");
    autosave_->enter({"session"});
  }
  ~MapAutosaveInASession() override { unsetenv("ROS_HOME"); }

  /// A map with one known cell.
  static occupancy::OccupancyMap mapAt(double x) {
    occupancy::OccupancyMap map;
    map.reserve({x, 0.0}, {x + 1.0, 1.0});
    map.beginScan();
    map.hit({0, 0});
    return map;
  }
  /// Another map is loaded in place of the one that is kept, while the disk is busy until the promise is kept.
  std::promise<void> loadWhileTheDiskIsBusy() {
    EXPECT_EQ(save(mapAt(0.0), {kThere, true}), "");
    autosave_->supersede();
    setDiskPatience(std::chrono::milliseconds(50));
    std::promise<void> end;
    diskThread().run<int>([busy = end.get_future().share()] { return busy.wait(), 0; });
    return end;
  }
  std::string save(occupancy::OccupancyMap map, const MapPose& pose) {
    autosave_->save(map, pose, {++scans_, 0}, [](const std::function<void()>& job) { job(); });
    return autosave_->whyNotSaved();
  }
  /// What a mapper continues with that is started now.
  std::optional<MapPose> restored() {
    MapAutosave next("");
    next.enter({"session"});
    occupancy::OccupancyMap map;
    return next.restore(map);
  }

  const test::TemporaryFolder home_;
  std::optional<MapAutosave> autosave_;
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

// [FLT-2] [MAP-5]
TEST_F(MapAutosaveInASession, OfAMapThatWasLoadedIsNotContinuedWithAtThePlaceOnTheMapBefore_FLT_2_MAP_5) {
  std::promise<void> end = loadWhileTheDiskIsBusy();
  EXPECT_NE(save(mapAt(5.0), {Pose2(), false}), "") << "the pose could not be written";
  end.set_value();
  EXPECT_THROW(restored(), std::runtime_error) << "neither map is there beside that pose";
}

// [FLT-2] [MAP-5]
TEST_F(MapAutosaveInASession, OfAMapThatWasLoadedIsThereAlsoIfTheDiskIsBusyForAMoment_FLT_2_MAP_5) {
  std::promise<void> end = loadWhileTheDiskIsBusy();
  std::thread disk([&end] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    end.set_value();
  });
  EXPECT_EQ(save(mapAt(5.0), {Pose2(), false}), "");
  disk.join();
  const auto pose = restored();
  ASSERT_TRUE(pose);
  EXPECT_FALSE(pose->localized);
}

}  // namespace
}  // namespace frontier_pilot
