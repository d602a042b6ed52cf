#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "frontier_pilot/logs/scan_log.h"
#include "frontier_pilot/logs/trajectory.h"

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

}  // namespace
}  // namespace frontier_pilot
