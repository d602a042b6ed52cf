#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "frontier_pilot/map_files/map_io.h"
#include "map_files/folder_lock.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

using Contents = std::array<std::string, 3>;
const std::array<std::string, 3> kNames = {"floor.pgm", "floor.bt", "floor.yaml"};

/// The names of the files that take their place in a folder while it is watched, in their order.
class Arrivals {
 public:
  explicit Arrivals(const fs::path& folder) { inotify_add_watch(queue_, folder.c_str(), IN_MOVED_TO); }
  ~Arrivals() { close(queue_); }
  Arrivals(const Arrivals&) = delete;
  Arrivals& operator=(const Arrivals&) = delete;

  std::vector<std::string> take() const {
    std::array<char, 4096> events{};
    const ssize_t bytes = ::read(queue_, events.data(), events.size());
    std::vector<std::string> names;
    for (std::size_t at = 0; static_cast<ssize_t>(at) < bytes;) {
      inotify_event event{};
      std::memcpy(&event, &events[at], sizeof(event));
      names.emplace_back(&events[at + sizeof(event)]);
      at += sizeof(event) + event.len;
    }
    return names;
  }

 private:
  int queue_ = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
};

/// A small map, saved as `floor`, that has come on since.
class MapOverwriting : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(map.reserve({-3.0, -1.0}, {2.0, 11.0}), occupancy::MapRoom::kEnough);
    drawWall(17);
    ASSERT_TRUE(map_files::saveMap(map, path("floor")).ok());
    drawWall(30);
  }

  void drawWall(int x) {
    map.beginScan();
    for (int i = 0; i < 50; ++i) map.hit({x, 100 + i});
  }
  std::string path(const std::string& name) const { return (directory / name).string(); }
  std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  Contents readAll() const { return {read(kNames[0]), read(kNames[1]), read(kNames[2])}; }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }

  const test::TemporaryFolder temporary;
  const fs::path directory = temporary.path();
  occupancy::OccupancyMap map;
};

// [FLT-1] [MAP-5] Whoever saves may be killed at any moment.
TEST_F(MapOverwriting, LeavesOneOfTheTwoMapsWhereverItEnds_FLT_1_MAP_5) {
  const Contents before = readAll();
  const Arrivals arrivals(directory);
  ASSERT_TRUE(map_files::saveMap(map, path("floor")).ok());
  const std::vector<std::string> order = arrivals.take();
  ASSERT_EQ(order.size(), kNames.size());
  const Contents after = readAll();
  for (std::size_t done = 0; done <= order.size(); ++done) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      const bool is_new = std::find(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(done), kNames[i]) !=
                          order.begin() + static_cast<std::ptrdiff_t>(done);
      write(kNames[i], is_new ? after[i] : before[i]);
    }
    occupancy::OccupancyMap loaded;
    const map_files::MapIoResult result = map_files::loadMap(path("floor"), loaded);
    ASSERT_TRUE(result.ok()) << "after " << done << " of the files: " << result.text;
    EXPECT_EQ(result.text.find("not verified"), std::string::npos) << result.text;
  }
}

// [MAP-5] What was broken before a save is so after it.
TEST_F(MapOverwriting, DoesNotMakeABrokenMapAGoodOne_MAP_5) {
  std::string broken = read("floor.bt");
  broken.back() = static_cast<char>(broken.back() ^ 1);
  write("floor.bt", broken);
  ASSERT_TRUE(map_files::saveMap(map, path("floor")).ok());
  write("floor.bt", broken);
  occupancy::OccupancyMap loaded;
  EXPECT_EQ(map_files::loadMap(path("floor"), loaded).status, map_files::MapIoStatus::kBroken);
}

// [FLT-1]
TEST(FolderLock, IsForOneThatWritesOrSeveralThatRead_FLT_1) {
  using map_files::FolderLock;
  const test::TemporaryFolder folder;
  const auto isTaken = [&](FolderLock::Kind kind) { return FolderLock(folder.path(), kind, Duration{}).isTaken(); };
  {
    const FolderLock writes(folder.path(), FolderLock::Kind::kWrite, Duration{});
    EXPECT_FALSE(writes.isTaken());
    EXPECT_TRUE(isTaken(FolderLock::Kind::kWrite));
    EXPECT_TRUE(isTaken(FolderLock::Kind::kRead));
  }
  const FolderLock reads(folder.path(), FolderLock::Kind::kRead, Duration{});
  EXPECT_FALSE(isTaken(FolderLock::Kind::kRead));
  EXPECT_TRUE(isTaken(FolderLock::Kind::kWrite));
  EXPECT_FALSE(FolderLock(folder.path() / "nowhere", FolderLock::Kind::kWrite, Duration{}).isTaken());
}

// [FLT-1] Files of two maps lay under one name, and neither could be loaded.
TEST(MapOverwrite, LeavesOneMapWholeWhenTwoAreSavedAtTheSameMoment_FLT_1) {
  const test::TemporaryFolder folder;
  const std::string path = (folder.path() / "floor").string();
  const auto save = [&](int length, int times) {
    occupancy::OccupancyMap map;
    ASSERT_EQ(map.reserve({-3.0, -1.0}, {2.0, 11.0}), occupancy::MapRoom::kEnough);
    map.beginScan();
    for (int i = 0; i < length; ++i) map.hit({17, 100 + i});
    for (int i = 0; i < times; ++i) EXPECT_TRUE(map_files::saveMap(map, path).ok());
  };
  save(50, 1);
  std::thread one(save, 50, 50), another(save, 90, 50);
  for (int i = 0; i < 50; ++i) {
    occupancy::OccupancyMap loaded;
    const map_files::MapIoResult result = map_files::loadMap(path, loaded);
    EXPECT_TRUE(result.ok()) << result.text;
    EXPECT_EQ(result.text.find("edited"), std::string::npos) << result.text;
  }
  one.join();
  another.join();
}

}  // namespace
}  // namespace frontier_pilot
