#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <string>

#include "frontier_pilot/map_files/map_io.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

constexpr int kAll = std::numeric_limits<int>::max();
int renames_left = kAll;  ///< so many files still take their place on the disk

}  // namespace
}  // namespace frontier_pilot

/// Takes the place of the C library's in this program: files are renamed until `renames_left` is used up, and stay as
/// they are from then on, as they do where the process dies.
extern "C" int rename(const char* from, const char* to) noexcept {
  if (frontier_pilot::renames_left == 0) {
    errno = EIO;
    return -1;
  }
  --frontier_pilot::renames_left;
  return static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

namespace frontier_pilot {
namespace {

/// What is saved as `floor`, over what is there before.
class InterruptedSave : public ::testing::Test {
 protected:
  void SetUp() override {
    drawFloor(before_);
    before_.hit(kErased);
    drawFloor(edited_);
    edited_.miss(kErased);
    drawFloor(now_);
    now_.miss(kErased);
    now_.hit(kNew);
  }
  void TearDown() override { renames_left = kAll; }

  static void drawFloor(occupancy::OccupancyMap& map) {
    ASSERT_EQ(map.reserve({0.0, 0.0}, {1.0, 1.0}), occupancy::MapRoom::kEnough);
    map.beginScan();
    for (int x = 5; x < 15; ++x) map.miss({x, 10});
    map.hit({12, 12});
  }
  std::string path(const std::string& name) const { return (temporary_.path() / name).string(); }
  std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  /// The disk is not waited for: these processes die, and the computer goes on.
  map_files::MapIoResult tryToSave(const occupancy::OccupancyMap& map) const {
    return map_files::saveMap(map_files::takeSnapshot(map), path("floor"), Survives::kProcessDeath);
  }
  void save(const occupancy::OccupancyMap& map) const {
    const map_files::MapIoResult saved = tryToSave(map);
    ASSERT_TRUE(saved.ok()) << saved.text;
  }
  /// Saves `before_`, and leaves the picture as somebody does who erases a wall of it.
  void editPicture() const {
    save(before_);
    write("floor.pgm", map_files::takeSnapshot(edited_).picture);
  }
  /// Overwrites the YAML and the picture as map_server's map_saver does.
  void saveWithAnotherProgram() const {
    save(edited_);
    const std::string yaml = read("floor.yaml");
    write("floor.yaml", yaml.substr(0, yaml.find("octree:")));
  }

  /// Saves over what `prepare` leaves, and is interrupted at every point one after the other: each time the files are
  /// those of the edited map, which was there, or those of the map that is saved.
  void expectAWholeMapWhereverItEnds(const std::function<void()>& prepare) const {
    bool complete = false;
    for (int renames = 0; !complete; ++renames) {
      for (const char* name : {"floor.yaml", "floor.bt", "floor.pgm"}) std::filesystem::remove(path(name));
      prepare();
      renames_left = renames;
      const map_files::MapIoResult saved = tryToSave(now_);
      complete = saved.ok();
      renames_left = kAll;
      const bool says_nothing = saved.text.find("nothing was replaced") != std::string::npos;
      EXPECT_EQ(says_nothing, renames == 0) << "after " << renames << " files: " << saved.text;
      occupancy::OccupancyMap loaded;
      const map_files::MapIoResult result = map_files::loadMap(path("floor"), loaded);
      ASSERT_TRUE(result.ok()) << "after " << renames << " files: " << result.text;
      const auto at = [&](Cell cell) {
        return loaded.grid().get(loaded.geometry().cellAt(now_.geometry().centre(cell)), kUnknown);
      };
      EXPECT_EQ(at(kErased), kFree) << "after " << renames << " files: " << result.text;
      EXPECT_TRUE(!complete || at(kNew) == kOccupied) << result.text;
    }
  }

  static constexpr Cell kErased{10, 12};
  static constexpr Cell kNew{3, 4};
  const test::TemporaryFolder temporary_;
  occupancy::OccupancyMap before_;  ///< with a wall
  occupancy::OccupancyMap edited_;  ///< the same without it
  occupancy::OccupancyMap now_;     ///< the edited one, that has come on since
};

// [FLT-1] [MAP-5] The octree of before the edit was loaded.
TEST_F(InterruptedSave, KeepsWhatWasEditedInThePictureThatItReplaces_FLT_1_MAP_5) {
  expectAWholeMapWhereverItEnds([this] { editPicture(); });
}

// [FLT-1] [MAP-5] The YAML named an octree that was not there.
TEST_F(InterruptedSave, LeavesTheMapOfAnotherProgramWhole_FLT_1_MAP_5) {
  expectAWholeMapWhereverItEnds([this] {
    saveWithAnotherProgram();
    std::filesystem::remove(path("floor.bt"));
  });
}

// [FLT-1] [MAP-5] The octree beside it was loaded, which is older.
TEST_F(InterruptedSave, LeavesTheMapThatAnotherProgramHasSavedOverOneWhole_FLT_1_MAP_5) {
  expectAWholeMapWhereverItEnds([this] {
    saveWithAnotherProgram();
    write("floor.bt", map_files::takeSnapshot(before_).octree);
  });
}

// [FLT-1] [MAP-5]
TEST_F(InterruptedSave, LeavesTheMapThatItReplacesOrTheNewOneWhole_FLT_1_MAP_5) {
  expectAWholeMapWhereverItEnds([this] { save(edited_); });
}

// [FLT-1] [MAP-5] An interrupted save is followed by another one that is interrupted.
TEST_F(InterruptedSave, LeavesAWholeMapWhereTheSaveBeforeWasInterruptedToo_FLT_1_MAP_5) {
  for (int first = 0; first <= 4; ++first) {
    expectAWholeMapWhereverItEnds([this, first] {
      editPicture();
      renames_left = first;
      tryToSave(now_);
      renames_left = kAll;
    });
  }
}

// [MAP-5] Nothing is replaced by a save that cannot be prepared: the YAML of an edited map keeps its octree.
TEST_F(InterruptedSave, ChangesNothingIfItsFilesCannotBeWritten_MAP_5) {
  editPicture();
  const std::string yaml = read("floor.yaml");
  std::filesystem::remove(path("floor.bt"));
  std::filesystem::create_directory(path("floor.bt"));
  EXPECT_EQ(tryToSave(now_).status, map_files::MapIoStatus::kCannotWrite);
  EXPECT_EQ(read("floor.yaml"), yaml);
}

}  // namespace
}  // namespace frontier_pilot
