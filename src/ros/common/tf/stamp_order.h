#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Tells transforms that are too old for a TF buffer from those that only look old beside a single one of the future,
/// which would otherwise hide every true transform until its time has come. [FLT-1]
class StampOrder {
 public:
  enum class Verdict {
    kKeep,
    kRepeated,       ///< there is a transform of this frame and stamp already, and tf2 would log that there is
    kTooOld,         ///< older than the buffer keeps, beside the newest of this frame
    kForgetAndKeep,  ///< the newest of this frame is of the future: the buffer has to be emptied first
  };

  /// `kept`: how long the buffer keeps a transform.
  explicit StampOrder(Duration kept) : kept_(kept) {}

  /// Judges a transform of the frame `child`, and remembers its stamp if it is kept.
  Verdict judge(const std::string& child, Time stamp, Time now);
  void clear() { stamps_.clear(); }

 private:
  Duration kept_;
  std::map<std::string, std::set<Time>> stamps_;  ///< of what the buffer keeps, by frame
};

}  // namespace frontier_pilot
