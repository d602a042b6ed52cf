#include "mapping/mapping_health.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <string_view>

namespace frontier_pilot::mapping {
namespace {

constexpr Duration kWindow = std::chrono::seconds(5);
constexpr std::size_t kMostScans = 1000;  ///< scans, as while the clock stands still
constexpr int kSlips = 2;                 ///< this many scans with a problem are not reported
constexpr double kLeastShare = 0.1;       ///< nor is a smaller share

}  // namespace

void MappingHealth::add(Time now, const char* remark) {
  if (!entries_.empty() && now < entries_.back().time) entries_.clear();
  entries_.push_back({now, remark});
  while (entries_.size() > kMostScans || now - entries_.front().time > kWindow) entries_.pop_front();
}

std::optional<ScanRemark> MappingHealth::worst(Time now) const {
  std::map<std::string_view, int> counts;
  int scans = 0;
  for (const Entry& entry : entries_) {
    if (now - entry.time > kWindow) continue;
    ++scans;
    if (entry.remark != nullptr) ++counts[entry.remark];
  }
  const auto most =
      std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == counts.end() || most->second <= kSlips) return std::nullopt;
  const double share = static_cast<double>(most->second) / scans;
  if (share < kLeastShare) return std::nullopt;
  return ScanRemark{std::string(most->first), share};
}

}  // namespace frontier_pilot::mapping
