#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace frontier_pilot {

/// What a node that drives is told of the emergency stop, so that no goal outlives a stop. A node that was held up (see
/// HoldUpWatch) may have missed something: a goal of that time may be read after both the stop and its clear, and an
/// arbiter that died meanwhile takes along what the node has not read yet. So the stop is told once more before each
/// clear, a clear that is read while the node is catching up waits until it has caught up, and if no arbiter of the
/// time before the hold-up lives any more, there may have been a stop. A node that connects to a new arbiter only after
/// a stop and its clear knows of them by the arbiter's count. [ARB-8] [FLT-2]
class StopFollower {
 public:
  using Uris = std::set<std::string>;

  /// `tell(stopped)` is called for each message, and for what may have been missed; `any_lives` says whether one of the
  /// processes with these addresses exists.
  StopFollower(std::function<void(bool)> tell, std::function<bool(const Uris&)> any_lives)
      : tell_(std::move(tell)), any_lives_(std::move(any_lives)) {}

  /// A message. `hold_ups` counts those of this process.
  void take(bool stopped, int hold_ups);
  /// How many stops the arbiter `node` has counted, in a status, and whether the robot was `stopped` then. `hold_ups`
  /// as above. Each node's count is compared with its own earlier one, because a recording may be played on the topic
  /// as well; that of a node which is heard for the first time with the one heard last, whose place it may have taken.
  void count(const std::string& node, std::uint64_t stops, bool stopped, int hold_ups);
  /// To be called often; `publishers` are the addresses of those from whom messages come, as of the last look, and the
  /// process is `catching_up` for a while after each hold-up.
  void tick(const Uris& publishers, int hold_ups, bool catching_up);

 private:
  struct Counted {
    std::uint64_t stops = 0;
    bool told = false;  ///< of a stop that may not have been counted yet
  };

  Counted& lastOf(const std::string& node, std::uint64_t stops);
  void endStopByCount();
  void noticeHoldUp(int hold_ups);

  std::function<void(bool)> tell_;
  std::function<bool(const Uris&)> any_lives_;
  bool stopped_ = false, clear_waits_ = false;
  std::map<std::string, Counted> counted_;  ///< by node
  std::string counted_last_;                ///< the node
  std::optional<std::string> by_count_of_;  ///< stopped, as far as only the count of this node tells
  int silent_ticks_ = 0;                    ///< since that node was heard
  int hold_ups_ = 0;
  bool caught_up_ = true;  ///< whether there was a tick since the last hold-up that did not catch up any more
  Uris publishers_;        ///< before the last hold-up; those that were heard last if there was none then
};

}  // namespace frontier_pilot
