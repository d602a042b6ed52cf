#include <gtest/gtest.h>

#include "frontier_pilot/core/bounds.h"
#include "ros/common/diagnostics.h"

namespace frontier_pilot {
namespace {

TEST(Rejections, FLT_1_AreCountedByReasonAsLongAsTheReasonsAreFewAndShort) {  // [FLT-1]
  Rejections rejections("scan");
  for (int i = 0; i < 1000; ++i) {
    rejections.add("frame '" + std::to_string(i) + std::string(1000, 'x') + "'");
    rejections.add("no ranges");
  }
  rejections.add("the newest");
  diagnostic_updater::DiagnosticStatusWrapper status;
  rejections.report(status);
  EXPECT_EQ(rejections.total(), 2001U);
  bool newest = false;
  EXPECT_LE(status.values.size(), bounds::kMostReasons + 3);
  std::size_t counted = 0;
  for (const auto& value : status.values) {
    EXPECT_LE(value.key.size(), bounds::kMostReason + 20);
    if (value.key != "scan refused") counted += std::stoul(value.value);
    newest = newest || value.key == "scan refused: the newest";
    EXPECT_TRUE(value.key != "scan refused: no ranges" || value.value == "1000") << value.value;
  }
  EXPECT_EQ(counted, 2001U);
  EXPECT_TRUE(newest);
}

TEST(Rejections, FLT_1_ShowWhatCameInWithoutItsControlCharacters) {  // [FLT-1]
  Rejections rejections("scan");
  rejections.add("frame 'a\nb\x1b[2J'");
  diagnostic_updater::DiagnosticStatusWrapper status;
  rejections.report(status);
  EXPECT_EQ(status.values.back().key, R"(scan refused: frame 'a\nb\x1b[2J')");
}

}  // namespace
}  // namespace frontier_pilot
