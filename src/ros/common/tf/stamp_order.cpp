#include "ros/common/tf/stamp_order.h"

#include <algorithm>

namespace frontier_pilot {
namespace {

Duration apart(Time a, Time b) { return a > b ? a - b : b - a; }

}  // namespace

StampOrder::Verdict StampOrder::judge(const std::string& child, Time stamp, Time now) {
  const auto known = newest_.emplace(child, stamp).first;
  Time& newest = known->second;
  if (newest - stamp <= kept_) {
    newest = std::max(newest, stamp);
    return Verdict::kKeep;
  }
  // If two stamps are that far apart, the one nearer to the clock is taken for the right one.
  if (newest <= now || apart(stamp, now) >= apart(newest, now)) return Verdict::kTooOld;
  clear();
  newest_.emplace(child, stamp);
  return Verdict::kForgetAndKeep;
}

}  // namespace frontier_pilot
