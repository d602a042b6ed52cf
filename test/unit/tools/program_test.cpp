#include "tools/program.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>
#include <stdexcept>

#include "support/temporary_folder.h"

namespace frontier_pilot {
namespace {

/// A program that writes more than the system allows it to.
int writeTooMuch(const std::string& path) {
  const rlimit limit{4096, 4096};
  setrlimit(RLIMIT_FSIZE, &limit);
  return tools::runProgram("writer", {}, "usage: writer\n", [&path](const auto&) {
    std::ofstream file(path);
    file << std::string(100000, 'x') << std::flush;
    if (!file) throw std::runtime_error("cannot be written");
    return 0;
  });
}

// [FLT-1]
TEST(Program, SaysThatAFileHasReachedALimitOfTheSystemInsteadOfBeingKilled) {
  const test::TemporaryFolder folder;
  EXPECT_EXIT(std::_Exit(writeTooMuch((folder.path() / "file").string())), ::testing::ExitedWithCode(1),
              "writer: cannot be written");
}

// [FLT-1] A name from a file or from the command line may hold anything.
TEST(Program, PrintsAnErrorWithoutControlCharacters_FLT_1) {
  ::testing::internal::CaptureStderr();
  tools::runProgram("reader", {}, "usage: reader\n",
                    [](const auto&) -> int { throw std::runtime_error("a\nb\x1b[31m"); });
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "reader: a\\nb\\x1b[31m\n");
}

}  // namespace
}  // namespace frontier_pilot
