#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Tells transforms that are too old for a TF buffer from those that only look old beside a single one of the future,
/// which would otherwise hide every true transform until its time has come. [FLT-1]
class StampOrder {
 public:
  enum class Verdict {
    kKeep,
    kTooOld,         ///< older than the buffer keeps, beside the newest of this frame
    kForgetAndKeep,  ///< the newest of this frame is of the future: the buffer has to be emptied first
  };

  /// `kept`: how long the buffer keeps a transform.
  explicit StampOrder(Duration kept) : kept_(kept) {}

  /// Judges a transform of the frame `child` and remembers it unless it is too old.
  Verdict judge(const std::string& child, Time stamp, Time now);
  void clear() { newest_.clear(); }

 private:
  Duration kept_;
  std::map<std::string, Time> newest_;  ///< by frame
};

}  // namespace frontier_pilot
