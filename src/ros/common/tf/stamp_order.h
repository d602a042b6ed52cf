#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Tells transforms that are too old for a TF buffer from those that only look old because a single transform of their
/// frame had a stamp in the future. That one would otherwise make the buffer reject all correct transforms until its
/// time has come. [FLT-1]
class StampOrder {
 public:
  enum class Verdict {
    kKeep,
    kRepeated,       ///< a transform of this frame has this stamp already: tf2 would log a warning for each one
    kTooOld,         ///< compared with the newest of this frame, older than the buffer keeps
    kForgetAndKeep,  ///< the newest of this frame lies in the future: clear the buffer, then keep this one
    kTooMany,        ///< there are kMost of this frame: clear the buffer, then keep this one
  };

  /// Transforms of a frame that are kept: ten seconds at 2 kHz. tf2 itself has no such limit. [FLT-1]
  static constexpr std::size_t kMost = 20'000;

  /// `kept`: how long the buffer keeps a transform.
  explicit StampOrder(Duration kept) : kept_(kept) {}

  /// Judges a transform of the frame `child`, and remembers its stamp if it is kept.
  Verdict judge(const std::string& child, Time stamp, Time now);
  void clear() { stamps_.clear(); }

 private:
  void startAnewWith(const std::string& child, Time stamp);

  Duration kept_;
  std::map<std::string, std::set<Time>> stamps_;  ///< of what the buffer keeps, by frame
};

}  // namespace frontier_pilot
