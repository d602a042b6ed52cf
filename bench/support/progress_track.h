#pragma once

#include <string>
#include <vector>

#include "frontier_pilot/exploration/explorer_types.h"

namespace frontier_pilot::bench {

/// What the explorer said of the whole during a run, compared with how it ended. [EXP-12]
class ProgressTrack {
 public:
  /// `time` since the start [s].
  void add(double time, const exploration::ExplorerProgress& progress);
  /// At a quarter, half and three quarters of the time: the error of the estimated area as a share of the area explored
  /// at the end, whether that area was within one standard deviation, and the error of the time left as a share of the
  /// whole time.
  std::string text() const;

 private:
  struct Sample {
    double time = 0.0;
    exploration::ExplorerProgress progress;
  };
  std::string textAt(double share) const;

  std::vector<Sample> samples_;
};

}  // namespace frontier_pilot::bench
