#include "frontier_pilot/core/text.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

TEST(Characters, AreReadFromUtf8) {
  const std::string text = "a\u00e9\u20ac\U0001F3E0";
  std::u32string codes;
  for (std::size_t i = 0; i < text.size(); i += characterAt(text, i).bytes) codes += characterAt(text, i).code;
  EXPECT_EQ(codes, U"a\u00e9\u20ac\U0001F3E0");
}

// [FLT-1]
TEST(Characters, FLT_1_AreNotReadFromWhatIsCutTooLongOrBeyondTheLast) {
  for (const char* text : {"\x80", "\xff", "\xc3", "\xc3z", "\xe2\x82", "\xc0\xaf", "\xe0\x80\xaf", "\xf0\x80\x80\xaf",
                           "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80"}) {
    EXPECT_EQ(characterAt(text, 0).bytes, 0U) << text;
  }
}

TEST(Characters, OfAnyLanguageAreNoControls) {
  const std::u32string text = U"az ~\u00a0\u00e9\u0627\u05d0\u200d\u2013\u697c\ufeff\ufffd\U0001F3E0";
  for (const char32_t code : text) EXPECT_FALSE(isControl(code)) << static_cast<unsigned>(code);
}

// [FLT-1]
TEST(Characters, FLT_1_ThatActOnWhatShowsThemAreControls) {
  for (const char32_t code : {0x00U, 0x0AU, 0x1BU, 0x7FU, 0x80U, 0x85U, 0x9BU, 0x9FU, 0x2028U, 0x2029U, 0x202EU,
                              0x2066U, 0xFFFEU, 0xFFFFU, 0x1FFFFU}) {
    EXPECT_TRUE(isControl(code)) << static_cast<unsigned>(code);
  }
}

// [FLT-1] It can neither forge a line of a log nor speak to the terminal that shows it.
TEST(PrintableText, FLT_1_ShowsWhatWouldActOnWhatShowsIt) {
  EXPECT_EQ(printable("frame 'map' of \u697c", 100), "frame 'map' of \u697c");
  EXPECT_EQ(printable("a\n[ERROR] b\x1b[2J\t\r\x7f", 100), "a\\n[ERROR] b\\x1b[2J\\t\\r\\x7f");
  EXPECT_EQ(printable("a\u0085b\u2028c\u202e", 100), "a\\u0085b\\u2028c\\u202e");
  EXPECT_EQ(printable("\xff"
                      "a\xc3",
                      100),
            "\\xffa\\xc3");
  EXPECT_EQ(printable(std::string(1, '\0'), 100), "\\x00");
}

TEST(PrintableText, IsCutBetweenCharacters) {
  EXPECT_EQ(printable("abcdef", 6), "abcdef");
  EXPECT_EQ(printable("abcdef", 5), "abcde ...");
  EXPECT_EQ(printable("abc\u20acf", 5), "abc ...");
  EXPECT_EQ(printable("abc\n", 4), "abc ...");
}

TEST(PrintableText, StaysAsItIsWhenItIsMadePrintableAgain) {
  const std::string once = printable("a\nb\\c\xff\u2028", 100);
  EXPECT_EQ(printable(once, 100), once);
}

// [FLT-1] Two texts that mean one namespace would be two robots with the same topics.
TEST(RobotName, FLT_1_SaysANamespaceInOneWayOnly) {
  for (const char* name : {"robot1", "R", "site_2/robot_1"}) EXPECT_TRUE(isRobotName(name)) << name;
  for (const char* name : {"", "/", "/a", "a/", "a//b", "1a", "_a", "a/_b", "a b", "a-b", "~a", "a\nb"})
    EXPECT_FALSE(isRobotName(name)) << name;
}

}  // namespace
}  // namespace frontier_pilot
