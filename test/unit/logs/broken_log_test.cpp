#include <gtest/gtest.h>

#include <random>
#include <sstream>
#include <streambuf>
#include <utility>

#include "frontier_pilot/logs/scan_log.h"
#include "frontier_pilot/logs/trajectory.h"
#include "logs/text_reader.h"

namespace frontier_pilot {
namespace {

/// What reading came to: nothing, or what is wrong.
std::string problemOf(const std::string& text) {
  std::istringstream file(text);
  try {
    const logs::ScanLog log = logs::readScanLog(file, "drive.log");
    EXPECT_FALSE(log.records.empty());
    for (const logs::LogRecord& record : log.records) {
      EXPECT_GE(record.scan.ranges.size(), 2U);
      EXPECT_TRUE(std::isfinite(record.scan.angle_increment));
      EXPECT_LE(std::abs(toSeconds(record.scan.stamp)), 4294967296.0);
    }
  } catch (const logs::LogError& error) {
    EXPECT_NE(std::string(error.what()).find("drive.log"), std::string::npos) << error.what();
    return error.what();
  }
  return "";
}

std::string csv() {
  std::string text;
  for (int i = 0; i < 6; ++i) text += std::to_string(100 + i) + ",0." + std::to_string(i) + ",0,0,1.5,2.5,3.5,0\n";
  return text;
}

std::string carmen() {
  std::string text;
  for (int i = 0; i < 3; ++i)
    text += "FLASER 4 1.5 2.5 3.5 0.5 1 2 0.5 1 2 0.5 100." + std::to_string(i) + " host 0.1\n";
  for (int i = 0; i < 3; ++i) {
    text +=
        "ROBOTLASER1 0 -1.57 3.14 1.57 81.9 0.01 1 3 1.5 81.92 4.5 3 10 20 30 1.25 2 0.5 1 2 0.5 0.1 0.2 0.3 0.4 "
        "99.0 100.5 host 0.7\n";
  }
  return text;
}

// [FLT-1]
TEST(BrokenLogs, AreReadOrRefusedWhateverTheyHold_FLT_1) {
  std::mt19937 random(20);
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  const std::string words[] = {"nan",         "inf",    "-1", "1e308", "18446744073709551615",
                               "99999999999", "FLASER", "\n", ",",     "#"};
  for (const std::string& whole : {csv(), carmen()}) {
    std::size_t refused = 0;
    for (int i = 0; i < 2000; ++i) {
      std::string text = whole;
      for (std::size_t flips = below(4); flips > 0; --flips) text[below(text.size())] = static_cast<char>(below(256));
      if (below(2) == 0) text.insert(below(text.size() + 1), words[below(std::size(words))]);
      if (below(4) == 0) text.resize(below(text.size()));
      refused += problemOf(text).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 100U);
  }
}

// [FLT-1] Nanoseconds since the epoch have 64 bits.
TEST(BrokenLogs, HaveNoTimeOrPlaceBeyondAllMeasure_FLT_1) {
  for (const char* number : {"1e11", "-1e11", "1e300", "9223372037"}) {
    EXPECT_NE(problemOf(std::string(number) + ",0,0,0,1,2\n").find("the stamp is too large"), std::string::npos)
        << number;
    EXPECT_NE(problemOf("1," + std::string(number) + ",0,0,1,2\n").find("too large"), std::string::npos) << number;
  }
  EXPECT_EQ(problemOf("4294967295,0,0,0,1,2\n"), "");
}

// [FLT-1]
TEST(BrokenLog, ALineOfMoreValuesThanAnyScanHasIsRefusedByItsNumber_FLT_1) {
  std::string line = "1,0,0,0";
  for (int i = 0; i < 200000; ++i) line += ",1";
  EXPECT_NE(problemOf("1,0,0,0,1,2\n" + line + "\n").find("drive.log:2: has more than 108000 values"),
            std::string::npos);
}

/// A file that begins with `text` and goes on with one character, without an end of a line.
class LongLine : public std::streambuf {
 public:
  LongLine(std::string text, char character, std::size_t size)
      : text_(std::move(text)), fill_(kPart, character), left_(size) {
    begin();
  }
  std::size_t left() const { return left_; }

 protected:
  int_type underflow() override {
    if (left_ < kPart) return traits_type::eof();
    left_ -= kPart;
    setg(fill_.data(), fill_.data(), fill_.data() + kPart);
    return traits_type::to_int_type(*gptr());
  }
  pos_type seekoff(off_type /*offset*/, std::ios_base::seekdir /*from*/, std::ios_base::openmode /*which*/) override {
    return 0;
  }
  pos_type seekpos(pos_type /*position*/, std::ios_base::openmode /*which*/) override {
    begin();
    return 0;
  }

 private:
  void begin() { setg(text_.data(), text_.data(), text_.data() + text_.size()); }

  static constexpr std::size_t kPart = 65536;
  std::string text_, fill_;
  std::size_t left_;
};

// [FLT-1]
TEST(BrokenLogs, ALineWithoutAnEndIsNotReadToTheEndOfTheFile_FLT_1) {
  constexpr std::size_t kSize = 200'000'000;
  const auto problemOfLine = [](const std::string& begin, char character, const auto& read) -> std::string {
    LongLine bytes(begin, character, kSize);
    std::istream file(&bytes);
    try {
      read(file);
    } catch (const logs::LogError& error) {
      EXPECT_GT(bytes.left(), kSize - 20'000'000) << "it was read on";
      return error.what();
    }
    return "";
  };
  const auto log = [](std::istream& file) { logs::readScanLog(file, "drive.log"); };
  const auto relations = [](std::istream& file) { logs::readRelations(file, "relations", 2); };
  const std::string too_long = ":1: is longer than 4000000 bytes";
  for (const char character : {'\0', ' ', '#', '1', ','}) {
    EXPECT_EQ(problemOfLine("     ", character, log), "drive.log" + too_long) << character;
    EXPECT_EQ(problemOfLine("", character, relations), "relations" + too_long) << character;
  }
  EXPECT_EQ(problemOfLine("1, 2, 3", '0', log), "drive.log" + too_long);
}

// [FLT-1]
TEST(BrokenLogs, WhatIsNoNumberIsNotQuotedInFull_FLT_1) {
  EXPECT_LT(problemOf("1, 2, 3, " + std::string(1'000'000, 'x') + ", 1, 1\n").size(), 500U);
  EXPECT_NE(problemOf("1, 2, 3, a\1b, 1, 1\n").find("'a\\x01b'"), std::string::npos);
}

// [FLT-1]
TEST(BrokenLogs, WhatIsKeptOfAFileIsLimited_FLT_1) {
  std::istringstream file("\n1\n");
  logs::TextReader reader(file, "drive.log", " ");
  ASSERT_TRUE(reader.nextLine());
  reader.keep(3'000'000'000);
  reader.keep(1'000'000'000);
  try {
    reader.keep(1);
    FAIL() << "it was kept";
  } catch (const logs::LogError& error) {
    EXPECT_STREQ(error.what(), "drive.log:2: until here it takes more than 4 GB of memory");
  }
}

}  // namespace
}  // namespace frontier_pilot
