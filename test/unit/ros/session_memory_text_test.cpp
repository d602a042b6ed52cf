// Texts and names of sessions that must not break what a SessionMemory keeps.
#include <gtest/gtest.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ros/common/memory/session_memory.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

class SessionMemoryText : public ::testing::Test {
 protected:
  SessionMemory memory(const std::vector<std::string>& sessions) const {
    return {temporary.path(), sessions, "stopped", "/emergency_stop", SessionMemory::Owner::kService};
  }
  /// Whether `work` says in a process of its own, which is a child of this one and then gone, that it has succeeded.
  template <typename Work>
  static bool inAChild(const Work& work) {
    const pid_t child = fork();
    if (child == 0) _exit(work() ? 0 : 1);
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  /// What a child of this process finds in a new session of what another child, which is gone then, has remembered.
  std::string foundByTheNextOf(const std::string& text) const {
    inAChild([&] { return memory({"session"}).remember(text).empty(); });
    int found[2];
    EXPECT_EQ(pipe(found), 0);
    inAChild([&] {
      const std::string recalled = memory({"new"}).recall().value_or("nothing");
      return write(found[1], recalled.data(), recalled.size()) == static_cast<ssize_t>(recalled.size());
    });
    close(found[1]);
    std::string recalled(4096, ' ');
    recalled.resize(static_cast<std::size_t>(std::max<ssize_t>(0, read(found[0], recalled.data(), recalled.size()))));
    close(found[0]);
    return recalled;
  }

  const test::TemporaryFolder temporary;
};

// [ARB-7] [FLT-1] The second line of the file says whose it is.
TEST_F(SessionMemoryText, WithAnEndOfALineIsFoundByTheNextProcessToo_ARB_7_FLT_1) {
  EXPECT_EQ(foundByTheNextOf("called by /me"), "called by /me");
  EXPECT_EQ(foundByTheNextOf("called by /me\n1 2 3 4 a b\n"), "called by /me\\n1 2 3 4 a b\\n");
}

// [ARB-7] [FLT-1]
TEST_F(SessionMemoryText, ThatIsLargerThanAFileMayBeKeepsItsBeginning_ARB_7_FLT_1) {
  const SessionMemory own = memory({"session"});
  EXPECT_EQ(own.remember("called by /" + std::string(3'000'000, 'x')), "");
  EXPECT_EQ(own.recall().value_or("nothing").substr(0, 12), "called by /x");
  EXPECT_TRUE(isKeptByALivingProcess(own.files().front())) << "its writer can be told";
}

// [ARB-7] [FLT-2] A master that hangs just then tells no name.
TEST_F(SessionMemoryText, StaysInItsSessionAsLongAsNoOtherHasAName_ARB_7_FLT_2) {
  SessionMemory own = memory({"session"});
  EXPECT_EQ(own.remember("called by /me"), "");
  EXPECT_FALSE(own.enter({}));
  EXPECT_EQ(own.remember("called by /you"), "");
  EXPECT_EQ(memory({"session"}).recall(), "called by /you");
  SessionMemory unnamed = memory({});
  EXPECT_NE(unnamed.remember("called by /me"), "");
  EXPECT_TRUE(unnamed.enter({"session"})) << "it has a name at last";
  EXPECT_EQ(unnamed.remember("called by /them"), "");
}

// [FLT-2] The file that the dead process has left is then this one's own.
TEST_F(SessionMemoryText, OfANodeThatHadNoSessionAtFirstIsNotTakenForThatOfItsPredecessor_FLT_2) {
  const auto ofNode = [this](const std::vector<std::string>& sessions) {
    return SessionMemory(temporary.path(), sessions, "kept", "/me", SessionMemory::Owner::kNode);
  };
  EXPECT_TRUE(inAChild([&] { return ofNode({"session"}).remember("of the first").empty(); }));
  EXPECT_TRUE(inAChild([&] {
    SessionMemory second = ofNode({});
    second.enter({"session"});
    return second.remember("of the second").empty() && second.recall() == "of the second";
  }));
}

}  // namespace
}  // namespace frontier_pilot
