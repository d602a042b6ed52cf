// The files of a map that a mapper which died has left. [FLT-2]

#include "ros/mapper/kept_map.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "ros/common/memory/process_identity.h"

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

class KeptMap : public ::testing::Test {
 protected:
  KeptMap() { fs::create_directory(base_.parent_path()); }
  ~KeptMap() override { fs::remove_all(folder_); }

  void write(const std::string& content, const std::set<std::string>& endings = {".bt", ".pgm", ".yaml"}) {
    for (const std::string& ending : endings) std::ofstream(base_.string() + ending) << content;
  }
  static std::string contentOf(const std::string& path) {
    std::string text;
    std::ifstream(path) >> text;
    return text;
  }

  static fs::path newFolder() {
    std::string name = (fs::temp_directory_path() / "kept_map.XXXXXX").string();
    return mkdtemp(name.data());
  }

  const fs::path folder_ = newFolder();
  const fs::path base_ = folder_ / "session" / "kept_map.mapper";
};

// [FLT-2]
TEST_F(KeptMap, LostTwiceIsThereTwice_FLT_2) {
  write("first");
  const std::string first = kept_map::setAside(base_);
  write("second");
  const std::string second = kept_map::setAside(base_);
  EXPECT_FALSE(kept_map::exists(base_));
  EXPECT_EQ(contentOf(first + ".bt"), "first");
  EXPECT_EQ(contentOf(second + ".bt"), "second");
  EXPECT_EQ(kept_map::lastSetAside(base_), second);
}

// [FLT-2]
TEST_F(KeptMap, WithoutItsOctreeIsPutAsideAsWell_FLT_2) {
  write("picture", {".pgm", ".yaml"});
  EXPECT_TRUE(kept_map::exists(base_));
  EXPECT_EQ(contentOf(kept_map::setAside(base_) + ".pgm"), "picture");
  write("picture", {".pgm"});
  fs::create_symlink("nowhere", base_.string() + ".bt");
  EXPECT_EQ(contentOf(kept_map::setAside(base_) + ".pgm"), "picture");
  EXPECT_FALSE(kept_map::exists(base_));
}

// [FLT-2]
TEST_F(KeptMap, GoesToAnotherFolderWhereLostCannotBeWritten_FLT_2) {
  std::ofstream(base_.parent_path() / "lost") << "a file";
  write("map");
  EXPECT_EQ(contentOf(kept_map::setAside(base_) + ".bt"), "map");
  fs::remove(base_.parent_path() / "lost");
  fs::create_directories(base_.parent_path() / "lost" / "kept_map.mapper.bt" / "full");
  write("other");
  EXPECT_EQ(contentOf(kept_map::setAside(base_) + ".bt"), "other");
}

// [FLT-2]
TEST_F(KeptMap, LostAgainAndAgainKeepsTheFirstOnesAndTheLast_FLT_2) {
  for (int i = 1; i <= 12; ++i) {
    write(std::to_string(i));
    const std::string lost = kept_map::setAside(base_);
    ASSERT_NE(lost, "");
    EXPECT_EQ(kept_map::whereItIs(lost).find("replaces the one") != std::string::npos, i >= 9)
        << "those that go are told of";
  }
  EXPECT_EQ(contentOf((base_.parent_path() / "lost" / base_.filename()).string() + ".bt"), "1");
  EXPECT_EQ(contentOf(kept_map::lastSetAside(base_) + ".bt"), "12");
}

// A map that is only localised in is saved once, so that its files are older than those of runs that came and went
// since. [FLT-2]
TEST_F(KeptMap, OfAMapperThatRunsInAnotherSessionIsNotRemovedAsAnOldOne_FLT_2) {
  write("living");
  std::ofstream(base_) << "pose\n" << ProcessIdentity::own() << "\n";
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(24);
  fs::last_write_time(base_.string() + ".bt", long_ago);
  fs::path other;
  for (int i = 0; i < 5; ++i) {
    other = folder_ / ("session" + std::to_string(i)) / base_.filename();
    fs::create_directory(other.parent_path());
    std::ofstream(other.string() + ".bt") << i;
    fs::last_write_time(other.string() + ".bt", long_ago + std::chrono::hours(i + 1));
  }
  kept_map::removeOldest(other);
  EXPECT_TRUE(kept_map::exists(base_));
  EXPECT_FALSE(kept_map::exists(folder_ / "session0" / base_.filename())) << "the fourth of those whose mapper is gone";
  EXPECT_TRUE(kept_map::exists(folder_ / "session1" / base_.filename()));
}

// A mapper that is killed again and again while it saves would fill the disk. [FLT-2]
TEST_F(KeptMap, LeavesNoUnfinishedFiles_FLT_2) {
  const fs::path earlier = folder_ / "earlier" / base_.filename();
  fs::create_directory(earlier.parent_path());
  for (const fs::path& base : {base_, earlier}) {
    for (const char* ending : {".bt", ".pgm", ".yaml"}) {
      const std::string file = base.string() + ending + ".0123456789a";
      std::ofstream(file) << "half";
      fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1));
    }
  }
  std::ofstream(base_.string() + ".pgm.bcdefghijkl") << "being written";
  std::ofstream(base_.string() + ".bt.backup") << "somebody's own";
  write("whole");
  kept_map::removeOldest(base_);
  EXPECT_TRUE(fs::is_empty(earlier.parent_path()));
  EXPECT_FALSE(fs::exists(base_.string() + ".bt.0123456789a"));
  EXPECT_TRUE(fs::exists(base_.string() + ".bt.backup"));
  EXPECT_TRUE(fs::exists(base_.string() + ".pgm.bcdefghijkl"));
  EXPECT_EQ(contentOf(base_.string() + ".bt"), "whole");
}

// A mapper that takes its place in another session knows it by that time. [FLT-2]
TEST_F(KeptMap, KeepsItsPoseAndIsKnownAsThatOfAMapperThatLivedUntilNow_FLT_2) {
  std::ofstream(base_) << "pose";
  const auto before = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(base_, before);
  EXPECT_EQ(kept_map::renew({base_}), "");
  EXPECT_GT(fs::last_write_time(base_), before + std::chrono::minutes(30));
  EXPECT_EQ(contentOf(base_.string()), "pose");
  EXPECT_NE(kept_map::renew({folder_ / "gone"}), "");
  EXPECT_FALSE(fs::exists(folder_ / "gone"));
}

TEST_F(KeptMap, ThatIsNotThereCannotBePutAside) {
  EXPECT_FALSE(kept_map::exists(base_));
  EXPECT_EQ(kept_map::setAside(base_), "");
  EXPECT_EQ(kept_map::lastSetAside(base_), "");
}

}  // namespace
}  // namespace frontier_pilot
