#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "frontier_pilot/core/time.h"
#include "ros/common/master/master_state.h"

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

/// Whether nodes live, for threads that must neither wait for the master nor for a computer that does not answer.
class NodeWatch {
 public:
  /// Whether a node lives; nothing if nobody knows.
  using Question = std::function<std::optional<bool>(const std::string& node)>;

  explicit NodeWatch(Question question = lifeOf) : question_(std::move(question)) {}

  /// Whether `node` lives, as a look after `since` has found it. As long as that is not known, the next look finds out.
  std::optional<bool> lives(const std::string& node, SteadyTime since);
  /// Finds out what was asked for since the last look.
  void look();

 private:
  struct Finding {
    bool lives = true;
    SteadyTime time{};
  };

  Question question_;
  std::mutex mutex_;  ///< guards all that follow
  std::set<std::string> asked_;
  std::map<std::string, Finding> found_;  ///< by the last look that was to find out something
};

}  // namespace frontier_pilot
