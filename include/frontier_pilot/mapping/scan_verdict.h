#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace frontier_pilot::mapping {

/// What became of a scan. [MAP-4]
enum class ScanVerdict {
  kInserted,     ///< it is in the map
  kLocalized,    ///< it was used to localize the robot; the map stays as it is
  kNotMoved,     ///< the robot has not moved since the last one, and not enough time has passed
  kNoTransform,  ///< the pose of the scanner on the base is not known
  kNoOdometry,   ///< there is no odometry for its stamp
  kStale,        ///< its stamp is too old, or not newer than the last one's
  kFuture,       ///< its stamp lies ahead of the clock
  kWrongFrame,   ///< its frame is empty or not allowed
  kMalformed,    ///< its geometry is not finite or not that of a scan, or it has no ranges
  kAllInvalid,   ///< no beam is usable
  kOutOfBounds,  ///< the map would become too large
  kMisfit,       ///< it fits nowhere near, and would only corrupt the map
};
constexpr std::size_t kScanVerdicts = 12;

const char* toString(ScanVerdict verdict);

/// Whether the scan was lost to an error, rather than used or superfluous.
inline bool isDropped(ScanVerdict verdict) {
  return verdict != ScanVerdict::kInserted && verdict != ScanVerdict::kLocalized && verdict != ScanVerdict::kNotMoved;
}

/// A problem that many of the scans of the last seconds had in common.
struct ScanRemark {
  std::string text;
  double share = 0.0;  ///< of these scans, 0 ... 1
};

/// The number of scans by verdict.
class ScanCounts {
 public:
  void add(ScanVerdict verdict) { ++counts_[static_cast<std::size_t>(verdict)]; }
  std::uint64_t operator[](ScanVerdict verdict) const { return counts_[static_cast<std::size_t>(verdict)]; }
  /// How many were lost to an error.
  std::uint64_t dropped() const;

 private:
  std::array<std::uint64_t, kScanVerdicts> counts_{};
};

}  // namespace frontier_pilot::mapping
