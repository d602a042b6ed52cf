#include "frontier_pilot/core/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;
using Status = FileContent::Status;

class Files : public ::testing::Test {
 protected:
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  const test::TemporaryFolder temporary;
  const fs::path folder = temporary.path();
};

TEST_F(Files, HoldWhatWasWritten) {
  for (const std::string& content : {std::string(), std::string("a\0b\n", 4), std::string(3000000, 'x')}) {
    ASSERT_EQ(writeFile(folder / "a", content), "");
    EXPECT_EQ(readFile(folder / "a", 3000000).bytes, content);
  }
  EXPECT_EQ(count(), 1U);
}

TEST_F(Files, TakeTheirPlaceOnlyWhenTheyAreWhole) {
  ASSERT_EQ(writeFile(folder / "a", "old"), "");
  {
    AtomicFile file(folder / "a");
    ASSERT_EQ(file.write("new"), "");
    EXPECT_EQ(readFile(folder / "a", 10).bytes, "old");
    EXPECT_EQ(count(), 2U);
  }
  EXPECT_EQ(readFile(folder / "a", 10).bytes, "old");
  EXPECT_EQ(count(), 1U) << "one that does not get there is removed";
  AtomicFile file(folder / "a");
  EXPECT_EQ(file.commit(), "nothing was written");
  ASSERT_EQ(file.write("first"), "");
  ASSERT_EQ(file.write("second"), "");
  ASSERT_EQ(file.commit(), "");
  EXPECT_EQ(readFile(folder / "a", 10).bytes, "second");
  EXPECT_EQ(count(), 1U);
}

// [FLT-1]
TEST_F(Files, ReplaceALinkInsteadOfFollowingIt_FLT_1) {
  ASSERT_EQ(writeFile(folder / "victim", "precious"), "");
  fs::create_symlink(folder / "victim", folder / "a");
  for (const Survives survives : {Survives::kProcessDeath, Survives::kPowerLoss}) {
    ASSERT_EQ(writeFile(folder / "a", "new", survives), "");
    EXPECT_EQ(readFile(folder / "victim", 10).bytes, "precious");
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder / "a")));
  }
}

TEST_F(Files, AreReadableByWhoeverTheUsersMaskAllows) {
  const mode_t before = umask(0027);
  ASSERT_EQ(writeFile(folder / "a", "new"), "");
  umask(before);
  struct stat info {};
  ASSERT_EQ(stat((folder / "a").c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777U, 0640U);
}

TEST_F(Files, MayHaveTheLongestNameThereIs) {
  const fs::path target = folder / std::string(255, 'x');
  EXPECT_EQ(writeFile(target, "new"), "");
  EXPECT_EQ(readFile(target, 10).bytes, "new");
}

// [FLT-1]
TEST_F(Files, SayWhyTheyCannotBeWrittenAndLeaveNothingBehind_FLT_1) {
  EXPECT_EQ(writeFile(folder / "none" / "a", "new"), "No such file or directory");
  fs::create_directory(folder / "a");
  EXPECT_EQ(writeFile(folder / "a", "new"), "Is a directory");
  EXPECT_EQ(count(), 1U);
  if (fs::exists("/dev/full")) {
    EXPECT_NE(writeFile("/dev/full/a", "new"), "");
  }
}

// [FLT-1]
TEST_F(Files, AreFilesAndNothingElse_FLT_1) {
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const fs::path& odd : {folder / "pipe", folder, fs::path("/dev/zero")}) {
    EXPECT_EQ(readFile(odd, 10).problem, "is not a regular file") << odd;
  }
  EXPECT_EQ(readFile(folder / "none", 10).status, Status::kMissing);
  EXPECT_EQ(readFile(folder / std::string(300, 'x'), 10).status, Status::kRefused);
  ASSERT_EQ(writeFile(folder / "a", "12345678901"), "");
  EXPECT_EQ(readFile(folder / "a", 10).problem, "is larger than 10 bytes");
  EXPECT_TRUE(readFile(folder / "a", 11).ok());
}

TEST(FileNames, AreWhatPeopleAndYamlCanRead) {
  for (const char* name : {"floor", "a: b", "-", "~", "%a", " ", "été", "楼层", "\xF0\x9F\x8F\xA0"}) {
    EXPECT_EQ(fileNameProblem(name, 0), "") << name;
  }
  for (const char* name : {"", ".", ".."}) EXPECT_EQ(fileNameProblem(name, 0), "names no file");
  for (const char* name : {"a\nb", "\t", "\x7f", "\x1b[2J", "\u0080", "a\u0085b", "\u009b2J", "a\u2028b", "\u2029",
                           "\u202egpj", "\uffff"}) {
    EXPECT_EQ(fileNameProblem(name, 0), "holds a control character") << name;
  }
  for (const char* name : {"\xff", "a\xc3", "\x80", "\xc0\xaf", "\xed\xa0\x80", "\xe2\x82", "\xf4\x90\x80\x80"})
    EXPECT_EQ(fileNameProblem(name, 0), "is not UTF-8") << name;
  EXPECT_EQ(fileNameProblem(std::string(250, 'x'), 5), "");
  EXPECT_EQ(fileNameProblem(std::string(251, 'x'), 5), "is longer than 250 bytes");
}

TEST(Crc32, IsTheOneThatEverybodyHas) {
  EXPECT_EQ(crc32(""), 0U);
  EXPECT_EQ(crc32("123456789"), 0xCBF43926U);
  EXPECT_EQ(crc32(std::string(1, '\0')), 0xD202EF8DU);
}

}  // namespace
}  // namespace frontier_pilot
