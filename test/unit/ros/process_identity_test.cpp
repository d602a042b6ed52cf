#include "ros/common/memory/process_identity.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sstream>

namespace frontier_pilot {
namespace {

/// One that was started by the process that has started this one, and has died.
ProcessIdentity deadSibling() {
  ProcessIdentity dead = ProcessIdentity::own();
  dead.process = fork();
  if (dead.process == 0) _exit(0);
  waitpid(dead.process, nullptr, 0);
  return dead;
}

// [ARB-7]
TEST(ProcessIdentity, IsWrittenAndReadOnOneLine_ARB_7) {
  const ProcessIdentity own = ProcessIdentity::own();
  std::stringstream text;
  text << own;
  ProcessIdentity read;
  text >> read;
  EXPECT_EQ(read.process, own.process);
  EXPECT_EQ(read.starter, own.starter);
  EXPECT_EQ(read.began, own.began);
  EXPECT_EQ(read.starter_began, own.starter_began);
  EXPECT_EQ(read.boot, own.boot);
  EXPECT_EQ(read.master, own.master);
}

// [ARB-7]
TEST(ProcessIdentity, IsReplacedOnlyIfItIsDeadAndTheStarterTheComputersRunAndTheMasterAreTheSame_ARB_7) {
  EXPECT_TRUE(ProcessIdentity::own().lives());
  EXPECT_FALSE(ProcessIdentity::own().isReplacedByThisOne()) << "it lives";
  const ProcessIdentity dead = deadSibling();
  EXPECT_FALSE(dead.lives());
  EXPECT_TRUE(dead.isReplacedByThisOne());
  ProcessIdentity other = dead;
  other.starter = getpid();
  EXPECT_FALSE(other.isReplacedByThisOne()) << "another process has started it";
  other = dead;
  other.starter_began += 1;
  EXPECT_FALSE(other.isReplacedByThisOne()) << "the number of its starter was used again";
  other = dead;
  other.boot = "another";
  EXPECT_FALSE(other.isReplacedByThisOne()) << "the computer was started again";
  other = dead;
  other.master = "-http://another:11311";
  EXPECT_FALSE(other.isReplacedByThisOne()) << "it is a robot of another master";
  EXPECT_FALSE(ProcessIdentity().isReplacedByThisOne()) << "nothing could be read";
}

}  // namespace
}  // namespace frontier_pilot
