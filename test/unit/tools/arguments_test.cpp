#include "tools/arguments.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace frontier_pilot {
namespace {

TEST(Arguments, GivesWordsAndTheirValues) {
  tools::Arguments arguments(
      {"drive.csv", "--range", "2.5", "--count=3", "--seeds", "2-4", "--one", "7", "--low", "-3-1"});
  EXPECT_EQ(arguments.next(), "drive.csv");
  EXPECT_TRUE(tools::Arguments::isOption(arguments.next()));
  EXPECT_EQ(arguments.number(), 2.5);
  EXPECT_EQ(arguments.next(), "--count");
  EXPECT_EQ(arguments.integer(), 3);
  arguments.next();
  EXPECT_EQ(arguments.range(), (std::vector<int>{2, 3, 4}));
  arguments.next();
  EXPECT_EQ(arguments.range(), (std::vector<int>{7}));
  arguments.next();
  EXPECT_EQ(arguments.range(), (std::vector<int>{-3, -2, -1, 0, 1}));
  tools::Arguments empty({"--seeds", "5-1"});
  empty.next();
  EXPECT_THROW(empty.range(), std::invalid_argument);
  EXPECT_TRUE(arguments.atEnd());
}

TEST(Arguments, NameTheOptionThatLacksItsValue) {
  const auto problemOf = [](const std::vector<std::string>& words) -> std::string {
    tools::Arguments arguments(words);
    arguments.next();
    try {
      arguments.number();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(problemOf({"--range"}), "--range needs a value");
  EXPECT_EQ(problemOf({"--range", ""}), "--range needs a value");
  EXPECT_EQ(problemOf({"--range", "far"}), "--range needs a number, not 'far'");
  EXPECT_EQ(problemOf({"--range", "2m"}), "--range needs a number, not '2m'");
  EXPECT_EQ(problemOf({"--range", "inf"}), "--range needs a finite number");
}

// [FLT-1]
TEST(Arguments, RefuseARangeThatWouldNotEnd_FLT_1) {
  for (const char* range : {"1-2147483647", "-2147483648-2147483647", "0-100000"}) {
    tools::Arguments arguments({"--seeds", range});
    arguments.next();
    EXPECT_THROW(arguments.range(), std::invalid_argument) << range;
  }
  tools::Arguments last({"--seeds", "2147483646-2147483647"});
  last.next();
  EXPECT_EQ(last.range().size(), 2U);
}

}  // namespace
}  // namespace frontier_pilot
