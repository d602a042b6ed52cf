#pragma once

#include <mutex>
#include <set>
#include <string>

namespace frontier_pilot {

/// Whether the processes that publish certain topics exist. roscpp keeps the link to a publisher that was killed, and
/// tries to connect to it again and again, so that its subscribers still count it. [FLT-1]
class PublisherWatch {
 public:
  /// `topic`, a resolved name, is looked at from now on.
  void add(const std::string& topic);
  /// Looks at the publishers of all these topics that this node is connected to. It takes 0.3 s for each that does not
  /// answer, and longer while a name server is silent.
  void look();
  /// False if the last look found that none of the processes exists from which this node receives `topic`. In doubt, as
  /// for a process that hangs or a computer that does not answer, one may.
  bool mayBePublished(const std::string& topic) const;

 private:
  mutable std::mutex mutex_;  ///< guards all that follow
  std::set<std::string> topics_;
  std::set<std::string> dead_;  ///< those of them whose publishers no longer exist
};

}  // namespace frontier_pilot
