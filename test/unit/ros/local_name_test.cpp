#include "ros/common/master/local_name.h"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <string>

namespace frontier_pilot {
namespace {

// [FLT-2]
TEST(LocalName, BelongsToOneProcessAtATimeAndTellsWhich) {
  const std::string name = "/arbiter of test " + std::to_string(getpid());
  std::optional<LocalName> first(name);
  LocalName second(name);
  EXPECT_TRUE(first->take());
  EXPECT_TRUE(first->take()) << "it has the name already";
  EXPECT_FALSE(second.take());
  EXPECT_EQ(second.owner(), getpid());
  LocalName other(name + "/other");
  EXPECT_TRUE(other.take());
  first.reset();
  EXPECT_TRUE(second.take());
}

// [FLT-2]
TEST(LocalName, IsFreeWhenItsProcessIsKilled) {
  const std::string name = "/killed of test " + std::to_string(getpid());
  int pipe_ends[2];
  ASSERT_EQ(pipe(pipe_ends), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    LocalName taken(name);
    const char done = taken.take() ? 'y' : 'n';
    if (write(pipe_ends[1], &done, 1) != 1) _exit(1);
    for (;;) pause();
  }
  char done = 0;
  ASSERT_EQ(read(pipe_ends[0], &done, 1), 1);
  close(pipe_ends[0]);
  close(pipe_ends[1]);
  LocalName own(name);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(own.owner(), child);
  EXPECT_FALSE(own.take());
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(own.take());
}

TEST(LocalName, MayBeLongerThanAnAddressOfASocket) {
  const std::string longest = std::string(1000, 'x') + std::to_string(getpid());
  LocalName one(longest + "a");
  LocalName other(longest + "b");
  EXPECT_TRUE(one.take());
  EXPECT_TRUE(other.take());
  EXPECT_EQ(one.owner(), getpid());
}

}  // namespace
}  // namespace frontier_pilot
