#include "ros/common/tf/stamp_order.h"

#include <algorithm>

namespace frontier_pilot {
namespace {

Duration apart(Time a, Time b) { return a > b ? a - b : b - a; }

}  // namespace

StampOrder::Verdict StampOrder::judge(const std::string& child, Time stamp, Time now) {
  std::set<Time>& stamps = stamps_[child];
  const Time newest = stamps.empty() ? stamp : *stamps.rbegin();
  if (newest - stamp <= kept_) {
    if (!stamps.insert(stamp).second) return Verdict::kRepeated;
    stamps.erase(stamps.begin(), stamps.lower_bound(std::max(newest, stamp) - kept_));
    if (stamps.size() <= kMost) return Verdict::kKeep;
    startAnewWith(child, stamp);
    return Verdict::kTooMany;
  }
  // If two stamps are that far apart, the one nearer to the clock is taken for the right one.
  if (newest <= now || apart(stamp, now) >= apart(newest, now)) return Verdict::kTooOld;
  startAnewWith(child, stamp);
  return Verdict::kForgetAndKeep;
}

void StampOrder::startAnewWith(const std::string& child, Time stamp) {
  clear();
  stamps_[child] = {stamp};
}

}  // namespace frontier_pilot
