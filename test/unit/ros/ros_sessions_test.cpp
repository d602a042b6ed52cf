#include "ros/common/master/ros_sessions.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

namespace frontier_pilot {
namespace {

// [ARB-7] [FLT-2] A master in another container has the same process id whenever it is started.
TEST(RosSessions, AMasterWhoseProcessIsNotSeenHereNamesNoSession_ARB_7_FLT_2) {
  EXPECT_EQ(nameOfMaster(getpid()), "") << "this is no master";
  EXPECT_EQ(nameOfMaster(1 << 30), "");
}

// [ARB-7]
TEST(RosSessions, AMasterIsNamedByItsProcessAndWhenThatWasStarted_ARB_7) {
  const pid_t master = fork();
  if (master == 0) {
    execl("/bin/sleep", "rosmaster", "30", nullptr);
    _exit(1);
  }
  while (nameOfMaster(master).empty() && waitpid(master, nullptr, WNOHANG) == 0) usleep(1000);
  EXPECT_EQ(nameOfMaster(master).rfind("master-" + std::to_string(master) + "-", 0), 0U);
  kill(master, SIGKILL);
  waitpid(master, nullptr, 0);
  EXPECT_EQ(nameOfMaster(master), "");
}

}  // namespace
}  // namespace frontier_pilot
