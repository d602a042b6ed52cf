// What is remembered beside the map that a mapper leaves behind. [FLT-2]

#include "ros/mapper/kept_map.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace frontier_pilot {
namespace {

// [FLT-2]
TEST(KeptPose, IsReadBackExactlyWithTheFileThatItsMapperBeganWith_FLT_2) {
  for (const std::string file : {"", "/maps/floor", "/maps/with a space", "/maps/x map_file:=y"}) {
    for (const bool localized : {false, true}) {
      const auto kept = toKeptPose(toText({{Pose2(1.0 / 3.0, -2.0e5 / 7.0, 0.1), localized}, file}));
      ASSERT_TRUE(kept);
      EXPECT_EQ(kept->T_map_odom, Pose2(1.0 / 3.0, -2.0e5 / 7.0, 0.1));
      EXPECT_EQ(kept->map_file, file);
      EXPECT_EQ(kept->localized, localized);
    }
  }
}

// [FLT-2] [MAP-5]
TEST(KeptPose, OfAnEarlierVersionIsOneAroundWhichTheRobotIsLookedFor_FLT_2_MAP_5) {
  const auto kept = toKeptPose("1 2 0.5");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->T_map_odom, Pose2(1.0, 2.0, 0.5));
  EXPECT_FALSE(kept->map_file || kept->localized);
  const auto with_file = toKeptPose("1 2 0.5 map_file:=/maps/ localized");
  ASSERT_TRUE(with_file);
  EXPECT_EQ(with_file->map_file, "/maps/ localized");
  EXPECT_FALSE(with_file->localized);
}

// [FLT-2]
TEST(KeptPose, IsNoneIfNoRobotCanHaveIt_FLT_2) {
  for (const char* text : {"", "nowhere", "1 2", "1e9 -1e9 0", "nan 0 0", "0 0 7"})
    EXPECT_FALSE(toKeptPose(text)) << text;
}

// [FLT-2]
TEST(KeptPose, KnowsTheSameFileByItsWholePathInOneLine_FLT_2) {
  EXPECT_EQ(mapFileName(""), "");
  EXPECT_EQ(mapFileName("floor"), (std::filesystem::current_path() / "floor").string());
  EXPECT_EQ(mapFileName("/maps/../maps/floor"), "/maps/floor");
  EXPECT_EQ(mapFileName("/maps/two\nlines").find('\n'), std::string::npos);
}

}  // namespace
}  // namespace frontier_pilot
