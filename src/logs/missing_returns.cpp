#include <algorithm>
#include <cstdio>
#include <map>

#include "frontier_pilot/logs/scan_log.h"

namespace frontier_pilot::logs {
namespace {

constexpr double kMargin = 0.001;  ///< [m]: ranges in logs have steps of a centimetre or a millimetre

/// Whether some beams without a return are marked already.
bool marksMissingReturns(const ScanLog& log) {
  return std::any_of(log.records.begin(), log.records.end(), [](const LogRecord& record) {
    const auto& ranges = record.scan.ranges;
    return std::any_of(ranges.begin(), ranges.end(), [&](float range) { return range > record.scan.range_max; });
  });
}

/// How often each of the longest ranges occurs, by range.
using Counts = std::map<float, std::size_t>;

Counts longestRanges(const ScanLog& log) {
  constexpr std::size_t kKept = 2;
  Counts counts;
  for (const LogRecord& record : log.records) {
    for (const float range : record.scan.ranges) {
      if (!(range > 0.0F)) continue;
      if (counts.size() >= kKept && range < counts.begin()->first) continue;
      ++counts[range];
      if (counts.size() > kKept) counts.erase(counts.begin());
    }
  }
  return counts;
}

}  // namespace

void recogniseMissingReturns(ScanLog& log) {
  constexpr std::size_t kLeast = 20;
  constexpr std::size_t kTimes = 10;
  if (marksMissingReturns(log)) return;
  const Counts counts = longestRanges(log);
  if (counts.size() < 2) return;
  const auto& [range, count] = *counts.rbegin();
  if (count < kLeast || count < kTimes * counts.begin()->second) return;
  for (LogRecord& record : log.records) {
    LaserScan2& scan = record.scan;
    if (scan.range_max >= range) scan.range_max = std::max(scan.range_min, static_cast<double>(range) - kMargin);
  }
  char text[96];
  std::snprintf(text, sizeof(text), "the greatest range, %.2f m, occurs %zu times and is taken for no return",
                static_cast<double>(range), count);
  log.notes.emplace_back(text);
}

}  // namespace frontier_pilot::logs
