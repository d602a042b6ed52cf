// What counts of a file that the process of another launch has left in the session.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "ros/common/memory/memory_file.h"
#include "ros/common/memory/session_memory.h"
#include "ros/frontier_explorer/explorer_memory.h"
#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

using Texts = std::vector<std::string>;

class SessionMemoryLaunch : public ::testing::Test {
 protected:
  SessionMemory memory() const {
    return {temporary.path(), {"session"}, "paused", "/explore", SessionMemory::Owner::kService};
  }
  /// Of a process that is gone, and that was another one than this in what `change` makes of it.
  void leave(const std::string& text, const std::function<void(ProcessIdentity&)>& change) const {
    const std::filesystem::path own = memory().files().front();
    std::filesystem::create_directories(own.parent_path());
    ProcessIdentity writer = ProcessIdentity::own();
    writer.process = 2000000000;
    change(writer);
    std::ofstream(own.parent_path() / "paused.explore~2000000000") << text << '\n' << writer;
  }

  const test::TemporaryFolder temporary;
};

// [FLT-2]
TEST_F(SessionMemoryLaunch, OfTheSameStarterCounts_FLT_2) {
  leave("not paused", [](ProcessIdentity&) {});
  EXPECT_EQ(memory().recallAll(), Texts{"not paused"});
  EXPECT_EQ(memory().recallOfThisLaunch(), Texts{"not paused"});
}

// [FLT-2]
TEST_F(SessionMemoryLaunch, DoesNotCountAfterTheComputerWasSwitchedOffWhileTheMasterLivedElsewhere_FLT_2) {
  leave("not paused", [](ProcessIdentity& writer) { writer.boot = "another"; });
  EXPECT_EQ(memory().recallAll(), Texts{"not paused"}) << "what keeps the robot still counts all the same";
  EXPECT_EQ(memory().recallOfThisLaunch(), Texts{});
}

// [FLT-2] This process has no roslaunch above it.
TEST_F(SessionMemoryLaunch, CountsForAProcessThatIsStartedByHandInAnotherShell_FLT_2) {
  leave("not paused", [](ProcessIdentity& writer) { writer.starter = getpid(); });
  EXPECT_EQ(memory().recallOfThisLaunch(), Texts{"not paused"});
}

// [FLT-2]
TEST_F(SessionMemoryLaunch, DoesNotCountIfItCannotBeToldWhoHasWrittenIt_FLT_2) {
  leave("not paused", [](ProcessIdentity& writer) { writer = {}; });
  EXPECT_EQ(memory().recallAll(), Texts{"not paused"});
  EXPECT_EQ(memory().recallOfThisLaunch(), Texts{});
}

// [EXP-10] [FLT-2]
TEST(ExplorerOrders, OfAnotherLaunchAreItsBoundsAndStops_EXP_10_FLT_2) {
  exploration::ExplorationBounds bounds;
  bounds.stay_within = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
  const ExplorerOrders kept = ofAnotherLaunch({bounds, true, Pose2(1.0, 2.0, 3.0), "the time has passed", 3});
  ASSERT_TRUE(kept.bounds);
  EXPECT_EQ(kept.bounds->stay_within, bounds.stay_within);
  EXPECT_EQ(kept.stops, 3U);
  EXPECT_FALSE(kept.returns_to_start || kept.start || kept.ended);
}

}  // namespace
}  // namespace frontier_pilot
