#include "frontier_pilot/mapping/mapper.h"

namespace frontier_pilot::mapping {

const char* toString(ScanVerdict verdict) {
  switch (verdict) {
    case ScanVerdict::kInserted:
      return "inserted";
    case ScanVerdict::kLocalized:
      return "localised";
    case ScanVerdict::kNotMoved:
      return "not moved";
    case ScanVerdict::kNoTransform:
      return "no transform";
    case ScanVerdict::kNoOdometry:
      return "no odometry";
    case ScanVerdict::kStale:
      return "stale";
    case ScanVerdict::kFuture:
      return "ahead of the clock";
    case ScanVerdict::kWrongFrame:
      return "wrong frame";
    case ScanVerdict::kMalformed:
      return "malformed";
    case ScanVerdict::kAllInvalid:
      return "all beams invalid";
    case ScanVerdict::kOutOfBounds:
      return "map too large, see max_side";
    case ScanVerdict::kTooFar:
      return "too far from the map's origin";
    case ScanVerdict::kMisfit:
      return "fits nowhere";
    case ScanVerdict::kNotLocated:
      return "not localised: the scan fits nowhere on the map here; give a pose, or call mapper/localize";
    case ScanVerdict::kBlind:
      return "sees none of the walls around, as a covered or failed scanner";
  }
  return "unknown";
}

std::uint64_t ScanCounts::dropped() const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (isDropped(static_cast<ScanVerdict>(i))) sum += counts_[i];
  }
  return sum;
}

}  // namespace frontier_pilot::mapping
