#include <gtest/gtest.h>

#include <sstream>

#include "frontier_pilot/logs/scan_log.h"

namespace frontier_pilot {
namespace {

/// A CARMEN log of scans of four beams: one that sees a wall up to 12 m away, two at 7 m and one that reports
/// `longest`.
logs::ScanLog logWith(double longest, int scans, const logs::LogScanner& scanner = {}) {
  std::ostringstream text;
  for (int i = 0; i < scans; ++i) {
    text << "FLASER 4 " << 1.0 + 0.05 * i << ' ' << 3.0 + 0.03 * i << ' ' << 6.0 + 0.02 * i << ' ' << longest
         << " 0 0 0 0 0 0 " << i << " host " << i << "\n";
  }
  std::istringstream file(text.str());
  return logs::readScanLog(file, "drive", scanner);
}

RangeKind lastBeamOf(const logs::ScanLog& log) { return readBeam(log.records.front().scan, 3).kind; }

TEST(MissingReturns, AreRecognisedByTheGreatestRangeThatOccursAgainAndAgain) {
  for (const double plateau : {50.0, 51.1, 8.183}) {
    const logs::ScanLog log = logWith(plateau, 40);
    EXPECT_EQ(lastBeamOf(log), RangeKind::kFree) << plateau;
    EXPECT_EQ(readBeam(log.records.front().scan, 1).kind, RangeKind::kHit) << plateau;
    ASSERT_EQ(log.notes.size(), 1U);
    EXPECT_NE(log.notes.front().find("40 times"), std::string::npos) << log.notes.front();
  }
}

TEST(MissingReturns, AreMarkedAlreadyByRangesBeyondTheScannersMaximum) {
  const logs::ScanLog log = logWith(81.83, 40);
  EXPECT_EQ(lastBeamOf(log), RangeKind::kFree);
  EXPECT_DOUBLE_EQ(log.records.front().scan.range_max, 80.0);
}

TEST(MissingReturns, AreNotSeenInAFewEqualRangesOrWhereTheScannerIsKnown) {
  EXPECT_EQ(lastBeamOf(logWith(50.0, 19)), RangeKind::kHit);
  logs::LogScanner scanner;
  scanner.range_max = 60.0;
  EXPECT_EQ(lastBeamOf(logWith(50.0, 40, scanner)), RangeKind::kHit);
}

TEST(MissingReturns, AreNotSeenInTheWallThatAStandingRobotMeasures) {
  std::ostringstream text;
  for (int i = 0; i < 60; ++i)
    text << "FLASER 3 7.0 11.99 " << (i % 2 == 0 ? 12.0 : 11.99) << " 0 0 0 0 0 0 " << i << " host " << i << "\n";
  std::istringstream file(text.str());
  const logs::ScanLog log = logs::readScanLog(file, "standing");
  EXPECT_EQ(readBeam(log.records.front().scan, 2).kind, RangeKind::kHit);
}

}  // namespace
}  // namespace frontier_pilot
