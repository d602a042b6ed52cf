// The mapper on the wire: this test is the robot, its scanner and everyone who listens.

#include <diagnostic_msgs/DiagnosticArray.h>
#include <frontier_pilot/SaveMap.h>
#include <gtest/gtest.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/GetMap.h>
#include <nav_msgs/MapMetaData.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// A scan of a round room of 3 m, taken from wherever the robot is: what matters is that the map follows. One beam
/// differs a little in every scan: a scanner that repeated itself to the last bit while the robot drives would be
/// taken for frozen.
sensor_msgs::LaserScan roundRoom(const ros::Time& stamp, float range = 3.0F) {
  sensor_msgs::LaserScan scan;
  scan.header.stamp = stamp;
  scan.header.frame_id = "base_scan";
  scan.angle_min = static_cast<float>(-M_PI);
  scan.angle_increment = static_cast<float>(2.0 * M_PI / 360.0);
  scan.angle_max = scan.angle_min + 359 * scan.angle_increment;
  scan.range_min = 0.12F;
  scan.range_max = 8.0F;
  static int scans = 0;
  scan.ranges.assign(360, range);
  scan.ranges[90] += 1e-6F * static_cast<float>(++scans);
  return scan;
}

class MapperOnTheWire : public ::testing::Test {
 protected:
  MapperOnTheWire() {
    // The test's own queue: nothing here has to keep a rate.
    scan_ = node_.advertise<sensor_msgs::LaserScan>("scan", 10);
    odom_ = node_.advertise<nav_msgs::Odometry>("odom", 10);
    map_listener_ = node_.subscribe("map", 10, &MapperOnTheWire::handleMap, this);
    update_listener_ = node_.subscribe("map_updates", 100, &MapperOnTheWire::handleUpdate, this);
    metadata_listener_ = node_.subscribe("map_metadata", 1, &MapperOnTheWire::handleMetadata, this);
    diagnostics_ = node_.subscribe("/diagnostics", 10, &MapperOnTheWire::handleDiagnostics, this);
  }
  void SetUp() override {
    mountScanner();
    ASSERT_TRUE(waitFor([&] { return scan_.getNumSubscribers() > 0 && odom_.getNumSubscribers() > 0; }));
  }

  static bool waitFor(const std::function<bool()>& condition, double seconds = 20.0) {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
    while (ros::ok() && ros::WallTime::now() < end) {
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
      if (condition()) return true;
    }
    return false;
  }

  static void mountScanner() {
    static tf2_ros::StaticTransformBroadcaster broadcaster;
    geometry_msgs::TransformStamped mount;
    mount.header.stamp = ros::Time::now();
    mount.header.frame_id = "base_footprint";
    mount.child_frame_id = "base_scan";
    mount.transform.translation.z = 0.18;
    mount.transform.rotation.w = 1.0;
    broadcaster.sendTransform(mount);
  }

  void publishOdometry(const ros::Time& stamp, double x) {
    nav_msgs::Odometry odom;
    odom.header.stamp = stamp;
    odom.header.frame_id = slash_ + "odom";
    odom.child_frame_id = "base_footprint";
    odom.pose.pose.position.x = x;
    odom.pose.pose.orientation.w = 1.0;
    odom_.publish(odom);
  }

  /// The robot at `x` sees the room.
  void look(double x, float range = 3.0F) {
    const ros::Time now = ros::Time::now();
    publishOdometry(now, x);
    sensor_msgs::LaserScan scan = roundRoom(now, range);
    scan.header.frame_id = slash_ + scan.header.frame_id;
    scan_.publish(scan);
  }
  /// Looks until `condition`: the mapper may not have TF yet.
  bool lookUntil(double x, const std::function<bool()>& condition) {
    return waitFor([&] {
      if (ros::WallTime::now() - last_look_ > ros::WallDuration(0.1)) {
        last_look_ = ros::WallTime::now();
        look(x);
      }
      return condition();
    });
  }
  bool mapExists() const { return !map_.data.empty(); }

  std::int8_t valueAt(const nav_msgs::OccupancyGrid& map, double x, double y) const {
    const int column = static_cast<int>(std::floor((x - map.info.origin.position.x) / map.info.resolution));
    const int row = static_cast<int>(std::floor((y - map.info.origin.position.y) / map.info.resolution));
    if (column < 0 || row < 0 || column >= static_cast<int>(map.info.width) ||
        row >= static_cast<int>(map.info.height)) {
      return -1;
    }
    return map.data[static_cast<std::size_t>(row) * map.info.width + static_cast<std::size_t>(column)];
  }
  std::string diagnostic(const std::string& key) const {
    for (const auto& value : status_.values) {
      if (value.key == key) return value.value;
    }
    return {};
  }
  int count(const std::string& key) const { return std::atoi(diagnostic(key).c_str()); }

  nav_msgs::OccupancyGrid currentMap() {
    nav_msgs::GetMap get;
    EXPECT_TRUE(ros::service::call("dynamic_map", get));
    return get.response.map;
  }

  void handleMap(const nav_msgs::OccupancyGrid& msg) {
    map_ = msg;
    ++maps_;
  }
  void handleMetadata(const nav_msgs::MapMetaData& msg) { metadata_ = msg; }
  void handleUpdate(const map_msgs::OccupancyGridUpdate& msg) {
    ++updates_;
    largest_update_ = std::max(largest_update_, msg.data.size());
    if (map_.data.empty()) return;
    ASSERT_LE(static_cast<unsigned>(msg.x) + msg.width, map_.info.width);
    ASSERT_LE(static_cast<unsigned>(msg.y) + msg.height, map_.info.height);
    for (unsigned row = 0; row < msg.height; ++row) {
      std::copy_n(msg.data.begin() + row * msg.width, msg.width,
                  map_.data.begin() + (static_cast<unsigned>(msg.y) + row) * map_.info.width + msg.x);
    }
  }
  void handleDiagnostics(const diagnostic_msgs::DiagnosticArray& msg) {
    for (const auto& status : msg.status) {
      if (status.name.find("mapping") != std::string::npos) status_ = status;
    }
  }

  ros::NodeHandle node_;
  ros::Publisher scan_, odom_;
  ros::Subscriber map_listener_, update_listener_, metadata_listener_, diagnostics_;
  nav_msgs::OccupancyGrid map_;  ///< the last whole map with the updates since
  nav_msgs::MapMetaData metadata_;
  diagnostic_msgs::DiagnosticStatus status_;
  ros::WallTime last_look_;
  std::string slash_;  ///< before the names of frames
  int maps_ = 0;
  int updates_ = 0;
  std::size_t largest_update_ = 0;
};

// [MAP-2]
TEST_F(MapperOnTheWire, ShowsFreeFloorWallsAndTheUnknown_MAP_2) {
  ASSERT_TRUE(lookUntil(0.0, [&] { return mapExists(); }));
  EXPECT_EQ(map_.header.frame_id, "map");
  EXPECT_EQ(valueAt(map_, 1.0, 1.0), 0);
  EXPECT_EQ(valueAt(map_, 3.02, 0.06), 100);
  EXPECT_EQ(valueAt(map_, 3.3, 0.06), -1);
  EXPECT_TRUE(waitFor([&] { return metadata_.width == map_.info.width; }));
}

// [MAP-2] applying the updates to an old map gives the new one
TEST_F(MapperOnTheWire, SendsUpdatesThatTurnTheOldMapIntoTheNewOne_MAP_2) {
  ASSERT_TRUE(lookUntil(0.0, [&] { return mapExists(); }));
  ASSERT_TRUE(lookUntil(0.3, [&] { return updates_ > 0 && valueAt(map_, 3.1, 0.01) == 0; }));
  EXPECT_LT(largest_update_, map_.data.size() / 2);
  ASSERT_TRUE(waitFor([&] { return currentMap().data == map_.data; }));
  const int maps = maps_;
  const auto patched = map_.data;
  ASSERT_TRUE(lookUntil(0.6, [&] { return maps_ > maps && map_.data != patched; })) << "the whole map follows";
  EXPECT_TRUE(waitFor([&] { return currentMap().data == map_.data; }));
}

TEST_F(MapperOnTheWire, PublishesMapToOdomAllTheTime) {
  tf2_ros::Buffer buffer;
  const tf2_ros::TransformListener listener(buffer);
  ASSERT_TRUE(waitFor([&] { return buffer.canTransform("map", "odom", ros::Time(0)); }));
  const auto first = buffer.lookupTransform("map", "odom", ros::Time(0));
  EXPECT_EQ(first.transform.translation.x, 0.0);
  EXPECT_EQ(first.transform.rotation.w, 1.0);
  EXPECT_TRUE(waitFor([&] {
    return buffer.lookupTransform("map", "odom", ros::Time(0)).header.stamp - first.header.stamp > ros::Duration(0.5);
  })) << "also while no scan comes";
}

// [MAP-4]
TEST_F(MapperOnTheWire, DropsAndCountsBadScansAndLosesNothing_MAP_4) {
  ASSERT_TRUE(lookUntil(0.0, [&] { return mapExists(); }));
  const auto before = currentMap().data;
  const ros::Time now = ros::Time::now();
  publishOdometry(now, 1.0);
  auto scan = roundRoom(now);
  scan.ranges.resize(17);
  scan_.publish(scan);
  scan = roundRoom(now);
  scan.angle_min = std::numeric_limits<float>::quiet_NaN();
  scan_.publish(scan);
  scan_.publish(roundRoom(now, std::numeric_limits<float>::quiet_NaN()));
  scan = roundRoom(now);
  scan.header.frame_id = "map";
  scan_.publish(scan);
  scan.header.frame_id = "nowhere";
  scan_.publish(scan);
  scan_.publish(roundRoom(now - ros::Duration(30.0)));
  scan_.publish(roundRoom(ros::Time(100.0)));  // as of a simulated robot, for a node that follows the computer's clock
  const char* other_clock =
      "scan refused: stale, by more than a minute: its stamp is of another clock than this node's, which is "
      "the computer's (use_sim_time is false)";
  EXPECT_TRUE(waitFor([&] {
    return count("scans, malformed") >= 2 && count("scans, all beams invalid") >= 1 &&
           count("scans, wrong frame") >= 1 && count("scans, no transform") >= 1 && count("scans, stale") >= 1 &&
           count(other_clock) == 1;
  })) << diagnostic("scans, malformed")
      << diagnostic("scans, all beams invalid") << diagnostic("scans, wrong frame") << diagnostic("scans, no transform")
      << diagnostic("scans, stale");
  EXPECT_TRUE(currentMap().data == before);
}

// [ROB-2]
TEST_F(MapperOnTheWire, AFrameMayBeginWithASlash) {
  slash_ = "/";
  const int seen = count("scans, inserted") + count("scans, not moved");
  EXPECT_TRUE(lookUntil(0.0, [&] { return count("scans, inserted") + count("scans, not moved") > seen + 10; }))
      << diagnostic("scans, no transform") << " without transform, " << diagnostic("scans, no odometry")
      << " without odometry";
}

TEST_F(MapperOnTheWire, SavesThreeFilesAndSaysWhyItCannot) {
  ASSERT_TRUE(lookUntil(0.0, [&] { return mapExists(); }));
  std::string folder = (fs::temp_directory_path() / "mapper_test_XXXXXX").string();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  frontier_pilot::SaveMap save;
  save.request.path = folder + "/floor";
  ASSERT_TRUE(ros::service::call("mapper/save_map", save));
  EXPECT_TRUE(save.response.success != 0) << save.response.message;
  for (const char* extension : {".pgm", ".yaml", ".bt"}) EXPECT_GT(fs::file_size(save.request.path + extension), 50U);
  save.request.path = folder + "/no/such/folder/floor";
  ASSERT_TRUE(ros::service::call("mapper/save_map", save));
  EXPECT_FALSE(save.response.success != 0);
  EXPECT_NE(save.response.message.find("no such directory"), std::string::npos);
  fs::remove_all(folder);
}

TEST_F(MapperOnTheWire, ForgetsTheMapOnResetAndKeepsItsSize) {
  ASSERT_TRUE(lookUntil(0.0, [&] { return mapExists(); }));
  const auto before = currentMap();
  std_srvs::Trigger reset;
  ASSERT_TRUE(ros::service::call("mapper/reset", reset));
  EXPECT_TRUE(reset.response.success != 0);
  const auto after = currentMap();
  EXPECT_EQ(after.info.width, before.info.width);
  EXPECT_EQ(std::count(after.data.begin(), after.data.end(), -1), static_cast<std::ptrdiff_t>(after.data.size()));
}

// [MAP-3] last: it silences the mapper for a while
TEST_F(MapperOnTheWire, KeepsSilentAndNamesTheNodeThatAlreadyOwnsTheMap_MAP_3) {
  ASSERT_TRUE(lookUntil(0.0, [&] { return mapExists(); }));
  ros::Publisher foreign = node_.advertise<nav_msgs::OccupancyGrid>("map", 1);
  ASSERT_TRUE(waitFor([&] { return status_.level == diagnostic_msgs::DiagnosticStatus::ERROR; }));
  EXPECT_NE(status_.message.find(ros::this_node::getName()), std::string::npos) << status_.message;
  const int maps = maps_;
  EXPECT_TRUE(waitFor([&] { return map_listener_.getNumPublishers() == 1; })) << "the mapper has withdrawn";
  foreign.shutdown();
  EXPECT_TRUE(lookUntil(0.9, [&] { return maps_ > maps; })) << "and is back when the other has gone";
}

}  // namespace

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "mapper_test");
  const ros::NodeHandle keep_alive;
  return RUN_ALL_TESTS();
}
