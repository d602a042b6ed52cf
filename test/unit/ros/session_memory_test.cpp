#include "frontier_pilot/ros/session_memory.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

class SessionMemoryFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "session_memory_XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    home = pattern;
  }
  void TearDown() override { fs::remove_all(home); }
  fs::path file() const { return home / "frontier_pilot" / "session" / "stopped.robot.arbiter"; }

  fs::path home;
  SessionMemory memory() const { return {home, {"session"}, "stopped", "/robot/arbiter"}; }
};

// [ARB-7]
TEST_F(SessionMemoryFile, IsFoundUnderEitherNameOfTheSessionAndNotInAnother_ARB_7) {
  SessionMemory both(home, {"run", "master"}, "stopped", "/arbiter");
  EXPECT_EQ(both.remember("called by /me"), "");
  EXPECT_TRUE(SessionMemory(home, {"master"}, "stopped", "/arbiter").recall())
      << "the run id is a parameter, and may be deleted";
  EXPECT_TRUE(SessionMemory(home, {"another run", "master"}, "stopped", "/arbiter").recall());
  EXPECT_FALSE(SessionMemory(home, {"another run", "another master"}, "stopped", "/arbiter").recall())
      << "a new session starts free";
  EXPECT_FALSE(both.enter({"run", "master"})) << "the session that it is in already";
  EXPECT_TRUE(both.enter({"another master"}));
  EXPECT_TRUE(both.recall()) << "what this process said counts until it says something else";
  EXPECT_EQ(both.forget(), "");
  EXPECT_FALSE(SessionMemory(home, {"run", "master"}, "stopped", "/arbiter").recall()) << "also where it was said";
}

// [ARB-7]
TEST_F(SessionMemoryFile, IsThereUntilItIsForgotten_ARB_7) {
  EXPECT_FALSE(memory().recall());
  EXPECT_EQ(memory().remember("called by /me"), "");
  EXPECT_EQ(memory().recall(), "called by /me");
  EXPECT_EQ(memory().remember("called by /you"), "");
  EXPECT_EQ(memory().recall(), "called by /you");
  EXPECT_EQ(std::distance(fs::directory_iterator(file().parent_path()), fs::directory_iterator()), 1);
  EXPECT_EQ(memory().forget(), "");
  EXPECT_FALSE(memory().recall());
}

// [ARB-7] [FLT-1]
TEST_F(SessionMemoryFile, OverwritesNothingThatALinkPointsAt_ARB_7_FLT_1) {
  fs::create_directories(file().parent_path());
  std::ofstream(home / "victim") << "precious";
  fs::create_symlink(home / "victim", file());
  EXPECT_EQ(memory().remember("called by /me"), "");
  std::ifstream victim(home / "victim");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(victim), {}), "precious");
  EXPECT_EQ(memory().recall(), "called by /me");
}

// [ARB-7] [FLT-1]
TEST_F(SessionMemoryFile, TakesWhatItCannotReadForAStop_ARB_7_FLT_1) {
  fs::create_directories(file().parent_path());
  ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
  EXPECT_EQ(memory().recall(), "");
  fs::remove(file());
  fs::create_symlink(home / "nowhere", file());
  EXPECT_EQ(memory().recall(), "");
  fs::remove(file());
  fs::create_directory(file());
  EXPECT_EQ(memory().recall(), "");
  EXPECT_NE(memory().remember("called by /me"), "");
}

/// Writes as a process that is gone now.
void writeAsADeadOne(const SessionMemory& memory, const std::string& text) {
  const pid_t writer = fork();
  if (writer == 0) {
    memory.remember(text);
    _exit(0);
  }
  waitpid(writer, nullptr, 0);
}

// [ARB-7]
TEST_F(SessionMemoryFile, IsFoundInANewSessionByAProcessThatWasStartedRightAfterItsWriterHadDied_ARB_7) {
  writeAsADeadOne(memory(), "called by /me");
  SessionMemory next(home, {"new master"}, "stopped", "/robot/arbiter");
  EXPECT_EQ(next.recall(), "called by /me") << "master and arbiter have died together, and the others drive on [ARB-7]";
  EXPECT_FALSE(SessionMemory(home, {"new master"}, "stopped", "/arbiter").recall()) << "that is another robot's";
  EXPECT_EQ(next.forget(), "");
  EXPECT_FALSE(SessionMemory(home, {"new master"}, "stopped", "/robot/arbiter").recall()) << "a clear clears it too";
}

// [ARB-7]
TEST_F(SessionMemoryFile, IsNotFoundInANewSessionOfAWriterThatLivesOrEndedInOrderOrDiedLongAgo_ARB_7) {
  const auto found = [&] {
    return SessionMemory(home, {"new master"}, "stopped", "/robot/arbiter").recall().has_value();
  };
  EXPECT_EQ(memory().remember("called by /me"), "");
  EXPECT_FALSE(found()) << "it is being used beside this one";
  writeAsADeadOne(memory(), "called by /me");
  EXPECT_TRUE(found());
  memory().endInOrder();
  EXPECT_FALSE(found());
  EXPECT_TRUE(memory().recall()) << "in its own session it holds";
  fs::last_write_time(file(), fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_FALSE(found());
}

}  // namespace
}  // namespace frontier_pilot
