#include "ros/common/memory/session_memory.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "frontier_pilot/core/files.h"
#include "ros/common/memory/disk.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

namespace fs = std::filesystem;

SessionMemory forNode(const fs::path& home, const std::vector<std::string>& sessions, const std::string& node) {
  return {home, sessions, "stopped", node, SessionMemory::Owner::kNode};
}

/// Of whoever offers the service.
SessionMemory forService(const fs::path& home, const std::vector<std::string>& sessions) {
  return {home, sessions, "stopped", "/robot/emergency_stop", SessionMemory::Owner::kService};
}

class SessionMemoryFile : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { setDiskPatience(std::chrono::seconds(20)); }

  fs::path file() const { return home / "frontier_pilot" / "session" / "stopped.robot.arbiter"; }

  const test::TemporaryFolder temporary;
  const fs::path home = temporary.path();
  SessionMemory memory() const { return forNode(home, {"session"}, "/robot/arbiter"); }
};

// [ARB-7]
TEST_F(SessionMemoryFile, IsFoundUnderEitherNameOfTheSessionAndNotInAnother_ARB_7) {
  SessionMemory both = forNode(home, {"run", "master"}, "/arbiter");
  EXPECT_EQ(both.remember("called by /me"), "");
  EXPECT_TRUE(forNode(home, {"master"}, "/arbiter").recall()) << "the run id is a parameter, and may be deleted";
  EXPECT_TRUE(forNode(home, {"another run", "master"}, "/arbiter").recall());
  EXPECT_FALSE(forNode(home, {"another run", "another master"}, "/arbiter").recall()) << "a new session starts free";
  EXPECT_FALSE(both.enter({"run", "master"})) << "the session that it is in already";
  EXPECT_TRUE(both.enter({"another master"}));
  EXPECT_TRUE(both.recall()) << "what this process said counts until it says something else";
  EXPECT_EQ(both.forget(), "");
  EXPECT_FALSE(forNode(home, {"run", "master"}, "/arbiter").recall()) << "also where it was said";
}

// [ARB-7]
TEST_F(SessionMemoryFile, IsKeptAtTheSparePlaceIfTheHomeCannotBeWritten_ARB_7) {
  std::ofstream(home / "file") << "no folder";
  const auto withSpare = [&] {
    return SessionMemory(home / "file", {"session"}, "stopped", "/stop", SessionMemory::Owner::kService,
                         home / "spare");
  };
  EXPECT_NE(SessionMemory(home / "file", {"session"}, "stopped", "/stop", SessionMemory::Owner::kService).problem(),
            "");
  EXPECT_EQ(withSpare().problem(), "");
  EXPECT_EQ(withSpare().remember("called by /me"), "");
  EXPECT_EQ(withSpare().recall(), "called by /me");
  withSpare().forget();
  EXPECT_FALSE(withSpare().recall());
}

// [ARB-7] The two places may not disagree: whatever was cleared is cleared at both.
TEST_F(SessionMemoryFile, IsForgottenAtBothPlaces_ARB_7) {
  const SessionMemory memory(home, {"session"}, "stopped", "/stop", SessionMemory::Owner::kService, home / "spare");
  EXPECT_EQ(memory.remember("called by /me"), "");
  EXPECT_EQ(memory.forget(), "");
  EXPECT_FALSE(forService(home, {"session"}).recall());
  EXPECT_FALSE(memory.recall());
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
  EXPECT_EQ(readFile(home / "victim", 100).bytes, "precious");
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

/// What a child of this process gives, which has ended then.
int inAChild(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  waitpid(child, &status, 0);
  return WEXITSTATUS(status);
}

/// Writes as a process that this one has started and that is gone now.
void writeAsADeadOne(const SessionMemory& memory) {
  inAChild([&] { return memory.remember("called by /me").empty() ? 0 : 1; });
}

/// Whether a process that is started now finds a stop under a new master.
bool isFoundByTheNext(const fs::path& home, const std::string& node) {
  return inAChild([&] { return forNode(home, {"new master"}, node).recall() ? 1 : 0; }) == 1;
}

// [ARB-7]
TEST_F(SessionMemoryFile, IsFoundInANewSessionByAProcessThatIsStartedInThePlaceOfItsWriter_ARB_7) {
  writeAsADeadOne(memory());
  EXPECT_TRUE(isFoundByTheNext(home, "/robot/arbiter")) << "master and arbiter died together, the others drive on";
  EXPECT_FALSE(isFoundByTheNext(home, "/arbiter")) << "that is another robot's";
  EXPECT_FALSE(forNode(home, {"new master"}, "/robot/arbiter").recall()) << "this is another launch";
  inAChild([&] { return forNode(home, {"new master"}, "/robot/arbiter").forget().empty() ? 0 : 1; });
  EXPECT_FALSE(isFoundByTheNext(home, "/robot/arbiter")) << "a clear clears it there too";
}

// [ARB-7]
TEST_F(SessionMemoryFile, IsNotFoundInANewSessionOfAWriterThatLivesOrEndedInOrderOrWasStartedByAnother_ARB_7) {
  EXPECT_EQ(memory().remember("called by /me"), "");
  EXPECT_FALSE(isFoundByTheNext(home, "/robot/arbiter")) << "it is being used beside the next one";
  writeAsADeadOne(memory());
  EXPECT_TRUE(isFoundByTheNext(home, "/robot/arbiter"));
  memory().endInOrder();
  EXPECT_FALSE(isFoundByTheNext(home, "/robot/arbiter"));
  EXPECT_TRUE(memory().recall()) << "in its own session it holds";
  writeAsADeadOne(memory());
  EXPECT_TRUE(isFoundByTheNext(home, "/robot/arbiter"));
  fs::last_write_time(file(), fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_FALSE(isFoundByTheNext(home, "/robot/arbiter")) << "what it wanted to do long ago";
}

/// A process that has done its work and lives until this object goes.
class LivingChild {
 public:
  explicit LivingChild(const std::function<void()>& work) {
    int done[2];
    EXPECT_EQ(pipe(done), 0);
    process_ = fork();
    if (process_ == 0) {
      work();
      EXPECT_EQ(write(done[1], "", 1), 1);
      for (;;) pause();
    }
    char byte = 0;
    EXPECT_EQ(read(done[0], &byte, 1), 1);
    close(done[0]);
    close(done[1]);
  }
  ~LivingChild() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  LivingChild(const LivingChild&) = delete;
  LivingChild& operator=(const LivingChild&) = delete;

 private:
  pid_t process_ = 0;
};

/// In a process with a number of its own.
void writeForServiceAsADeadOne(const fs::path& home) {
  inAChild([&] { return forService(home, {"session"}).remember("called by /me").empty() ? 0 : 1; });
}

// [ARB-7]
TEST_F(SessionMemoryFile, IsKeptUnderTheNameThatStaysWhenTheOtherOneOfTheSessionChanges_ARB_7) {
  SessionMemory own = forNode(home, {"run", "master"}, "/robot/arbiter");
  EXPECT_EQ(own.remember("called by /me"), "");
  EXPECT_TRUE(own.enter({"another", "master"}));
  EXPECT_EQ(own.remember("called by /me"), "");
  for (const char* session : {"another", "master"}) {
    EXPECT_TRUE(forNode(home, {session}, "/robot/arbiter").recall()) << session;
  }
  EXPECT_FALSE(forNode(home, {"run"}, "/robot/arbiter").recall()) << "the old name is taken off";
}

// [ARB-7] [ARB-12]
TEST_F(SessionMemoryFile, OfAServiceIsFoundByWhoeverOffersItNextUntilThatOneForgetsIt_ARB_7_ARB_12) {
  const SessionMemory own = forService(home, {"session"});
  writeForServiceAsADeadOne(home);
  EXPECT_EQ(own.recall(), "called by /me");
  EXPECT_EQ(own.remember("from before a restart"), "");
  EXPECT_EQ(own.recallAll(), std::vector<std::string>{"from before a restart"}) << "in the place of the dead one's";
  writeForServiceAsADeadOne(home);
  EXPECT_EQ(own.forget(), "");
  EXPECT_FALSE(own.recall());
}

// [ARB-7] [ARB-12]
TEST_F(SessionMemoryFile, OfAServiceIsNotForgottenForAnotherThatLives_ARB_7_ARB_12) {
  const SessionMemory own = forService(home, {"session"});
  {
    const LivingChild other([&] { forService(home, {"session"}).remember("called by /you"); });
    EXPECT_EQ(own.recallOthers(), "called by /you");
    EXPECT_EQ(own.remember("called by /me"), "");
    EXPECT_EQ(own.recallAll(), (std::vector<std::string>{"called by /me", "called by /you"}));
    EXPECT_EQ(own.forget(), "");
    EXPECT_EQ(own.recall(), "called by /you") << "that one is stopped still";
  }
  EXPECT_EQ(own.recall(), "called by /you") << "nor when it has died";
  EXPECT_EQ(own.forget(), "");
  EXPECT_FALSE(own.recall());
}

// [ARB-7] [ARB-12]
TEST_F(SessionMemoryFile, OfAServiceIsFoundInANewSessionByAProcessInThePlaceOfItsWriterOnly_ARB_7_ARB_12) {
  writeForServiceAsADeadOne(home);
  const auto is_found = [&] { return inAChild([&] { return forService(home, {"new"}).recall() ? 1 : 0; }) == 1; };
  EXPECT_TRUE(is_found());
  EXPECT_FALSE(forService(home, {"new"}).recall()) << "this is another launch";
}

// [ARB-7]
TEST_F(SessionMemoryFile, OfAServiceIsFoundInANewSessionHoweverLateItsWriterIsReplaced_ARB_7) {
  writeForServiceAsADeadOne(home);
  for (const auto& entry : fs::directory_iterator(file().parent_path())) {
    fs::last_write_time(entry.path(), fs::file_time_type::clock::now() - std::chrono::hours(1));
  }
  EXPECT_EQ(inAChild([&] { return forService(home, {"new"}).recall() ? 1 : 0; }), 1) << "roslaunch or it was frozen";
}

// [FLT-2] A master of the same session still has what the file says, unless somebody has removed it there.
TEST_F(SessionMemoryFile, OfALastingNodeIsFoundInANewSessionHoweverLateButNotTakenFromItsOwn_FLT_2) {
  const auto lasting = [&](const char* session) {
    return SessionMemory(home, {session}, "stopped", "/robot/arbiter", SessionMemory::Owner::kLastingNode);
  };
  writeAsADeadOne(lasting("session"));
  const fs::path kept = file().parent_path() / "lasting_stopped.robot.arbiter";
  fs::last_write_time(kept, fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_EQ(inAChild([&] { return static_cast<int>(lasting("new").recallFromElsewhere().size()); }), 1);
  EXPECT_EQ(inAChild([&] { return static_cast<int>(lasting("session").recallFromElsewhere().size()); }), 0);
}

// [ARB-7] [FLT-1]
TEST_F(SessionMemoryFile, OfAServiceTakesNoFileThatIsBeingWrittenForAStop_ARB_7_FLT_1) {
  const SessionMemory own = forService(home, {"session"});
  fs::create_directories(file().parent_path());
  std::ofstream(own.files().front().string() + ".a1b2c3") << "half";
  EXPECT_FALSE(own.recall());
}

// [FLT-1]
TEST_F(SessionMemoryFile, SaysWhyNothingCouldBeRememberedBeforeAnythingIs_FLT_1) {
  EXPECT_EQ(memory().problem(), "");
  EXPECT_FALSE(memory().recall()) << "nothing is left of the attempt";
  std::ofstream(home / "file") << "no folder";
  EXPECT_NE(forNode(home / "file", {"session"}, "/arbiter").problem(), "");
  EXPECT_NE(forNode(home, {}, "/arbiter").problem(), "");
  EXPECT_NE(forNode(home, {}, "/arbiter").remember("called by /me"), "") << "there is no session to remember it in";
}

// [FLT-1] Anybody may set the run id, a parameter.
TEST_F(SessionMemoryFile, LeavesNoFileOutsideOfTheFolderOfASession_FLT_1) {
  for (const std::string name : {"..", ".", "", "../..", "/tmp", "a/b", "a/../..", "two\nlines", ".hidden"}) {
    const SessionMemory memory = forNode(home, {name, "master"}, "/arbiter");
    EXPECT_EQ(memory.files(), forNode(home, {"master"}, "/arbiter").files()) << name;
    EXPECT_EQ(memory.remember("called by /me"), "") << name;
    EXPECT_NE(forNode(home, {name}, "/arbiter").remember("called by /me"), "") << name << " names no session";
  }
  EXPECT_NE(forNode(home, {std::string(300, 'a')}, "/arbiter").remember("x"), "");
  EXPECT_EQ(std::distance(fs::recursive_directory_iterator(home), {}), 3) << "home/frontier_pilot/master/<the file>";
}

}  // namespace
}  // namespace frontier_pilot
