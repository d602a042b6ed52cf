#include "ros/common/master/local_name.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <optional>

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
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    LocalName taken(name);
    taken.take();
    for (;;) pause();
  }
  LocalName own(name);
  for (int i = 0; i < 500 && own.owner() != child; ++i) usleep(10000);
  EXPECT_EQ(own.owner(), child);
  EXPECT_FALSE(own.take());
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(own.take());
}

TEST(LocalName, MayBeLongerThanAnAddressOfASocket) {
  LocalName longest(std::string(1000, 'x') + std::to_string(getpid()));
  EXPECT_TRUE(longest.take());
  EXPECT_EQ(longest.owner(), getpid());
}

}  // namespace
}  // namespace frontier_pilot
