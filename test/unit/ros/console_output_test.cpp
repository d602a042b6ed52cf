#include "ros/common/logging/console_output.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <string>

namespace frontier_pilot {
namespace {

constexpr std::size_t kMuch = 1 << 20;  // [bytes]: more than any pipe or terminal takes before somebody reads

/// Writes in lines, as a log does, until the reader's buffer is full; returns how much was taken.
std::size_t writeMuch(int descriptor) {
  const std::string line(100, 'x');
  std::size_t written = 0;
  while (written < kMuch) {
    const ssize_t n = ::write(descriptor, line.data(), line.size());
    if (n < 0) break;
    written += static_cast<std::size_t>(n);
  }
  return written;
}

bool waits(int descriptor) { return (fcntl(descriptor, F_GETFL) & O_NONBLOCK) == 0; }

TEST(ConsoleOutput, APipeThatNobodyReadsDoesNotHoldUpTheWriter_FLT_1) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const int of_another = ::dup(ends[1]);
  EXPECT_TRUE(dropUnreadOutput(ends[1]));
  EXPECT_LT(writeMuch(ends[1]), kMuch);
  EXPECT_EQ(errno, EAGAIN);
  EXPECT_TRUE(waits(of_another)) << "those who share the pipe are not affected";
  std::array<char, 100> line{};
  EXPECT_EQ(::read(ends[0], line.data(), line.size()), 100) << "what was taken can be read";
  for (const int each : {ends[0], ends[1], of_another}) ::close(each);
}

TEST(ConsoleOutput, ATerminalThatIsStoppedDoesNotHoldUpTheWriter_FLT_1) {
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(master, 0);
  ASSERT_EQ(grantpt(master), 0);
  ASSERT_EQ(unlockpt(master), 0);
  const int terminal = ::open(ptsname(master), O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  EXPECT_TRUE(dropUnreadOutput(terminal));
  EXPECT_LT(writeMuch(terminal), kMuch);
  ::close(terminal);
  ::close(master);
}

TEST(ConsoleOutput, AFileGetsEveryLine_FLT_1) {
  std::string path = ::testing::TempDir() + "console_output_XXXXXX";
  const int file = mkstemp(path.data());
  ASSERT_GE(file, 0);
  EXPECT_FALSE(dropUnreadOutput(file));
  EXPECT_TRUE(waits(file));
  EXPECT_GE(writeMuch(file), kMuch);
  ::close(file);
  unlink(path.c_str());
}

TEST(ConsoleOutput, AClosedDescriptorStaysClosed_FLT_1) {
  constexpr int kNotOpen = 1000;
  EXPECT_FALSE(dropUnreadOutput(kNotOpen));
  EXPECT_EQ(fcntl(kNotOpen, F_GETFL), -1);
}

}  // namespace
}  // namespace frontier_pilot
