#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/time.h"

namespace frontier_pilot::waypoints {

/// How waypoints are followed.
struct WaypointParameters {
  bool stop_on_failure = false;
  double navigation_timeout = 10.0;
  int max_waypoints = 1000;

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("stop_on_failure", stop_on_failure, "",
            "whether the rest is given up when a waypoint cannot be reached; otherwise the robot goes on to the next");
    v.field("navigation_timeout", navigation_timeout, "s",
            "time without a server of move_base after which the waypoints are given up", timeSpan());
    v.field("max_waypoints", max_waypoints, "", "greatest number of waypoints that is accepted", between(1, 10000));
  }
};

/// The state, or how the last waypoints ended.
enum class WaypointOutcome {
  kIdle,  ///< none yet
  kRunning,
  kCompleted,  ///< the robot went to all of them, except those that it missed
  kCanceled,
  kInvalidGoal,
  kEmergencyStop,
  kNavigationGone,
  kReplaced,          ///< another client sent a goal, or cancelled that of a waypoint
  kNavigationUnable,  ///< the navigation gave a goal up for no fault of the place, e.g. as not localised
  kWaypointMissed,
};

/// How the goal of a waypoint ended.
struct LegEnd {
  enum class Kind {
    kReached,
    kFailed,
    kReplaced,
    kUnable,  ///< the navigation gave it up for no fault of the place
    kLost,    ///< the server died: the goal is sent again
  };
  std::uint32_t leg = 0;  ///< as in WaypointOutput::send
  Kind kind = Kind::kFailed;
  std::string text;  ///< why
};

struct WaypointInputs {
  bool navigation_up = false;             ///< move_base is served now
  bool navigation_serves_others = false;  ///< a goal of another client is pursued, or was a moment ago
  bool emergency_stop = false;
  std::string navigation_refused;  ///< why the arbiter does not heed its commands; empty: it does
  std::vector<LegEnd> ended;       ///< since the last update
};

/// A goal that is to be sent.
struct Leg {
  std::uint32_t leg = 0;     ///< of this goal alone, whatever was sent before
  std::size_t waypoint = 0;  ///< counted from 0
};

struct WaypointOutput {
  WaypointOutcome outcome = WaypointOutcome::kIdle;
  std::optional<Leg> send;
  bool cancel = false;  ///< the goal that was sent last is to be cancelled
  bool ended = false;   ///< the waypoints ended in this update
  std::string text;     ///< how, once they have ended
};

/// Goes through waypoints in their order, each as a goal of the navigation. It knows them by number only. Whatever ends
/// it cancels the goal that is under way, except another goal that has replaced it. [NAV-5]
class WaypointFollower {
 public:
  explicit WaypointFollower(const WaypointParameters& parameters) : parameters_(parameters) {}

  /// Begins with new waypoints; those before must have ended. The first goal comes with the next update.
  WaypointOutput start(std::size_t count, Time now);
  WaypointOutput update(const WaypointInputs& inputs, Time now);
  /// Ends them before they have begun, because there is something wrong with them.
  WaypointOutput refuse(const std::string& why) { return end(WaypointOutcome::kInvalidGoal, why); }
  /// Ends them because the clock has jumped: what the navigation does then is an end of its goal, not of a waypoint.
  WaypointOutput abortByClockJump() {
    return active() ? end(WaypointOutcome::kNavigationGone, "aborted: the clock jumped") : unchanged();
  }
  /// Ends them because another map is there now, on which they mean other places.
  WaypointOutput abortByMap() {
    return active() ? end(WaypointOutcome::kNavigationUnable, "aborted: the map was replaced") : unchanged();
  }
  WaypointOutput cancel() { return active() ? end(WaypointOutcome::kCanceled, "canceled") : unchanged(); }

  bool active() const { return outcome_ == WaypointOutcome::kRunning; }
  /// The waypoint that the robot is sent to now, counted from 0; after the last one their number.
  std::size_t current() const { return current_; }
  std::size_t count() const { return count_; }
  /// Those that could not be reached.
  const std::vector<std::size_t>& missed() const { return missed_; }

 private:
  WaypointOutput unchanged() const;
  WaypointOutput end(WaypointOutcome outcome, const std::string& text);
  std::optional<WaypointOutput> take(const LegEnd& ended);
  std::optional<WaypointOutput> miss(const std::string& why);
  std::string inWords(std::size_t waypoint) const;

  WaypointParameters parameters_;
  WaypointOutcome outcome_ = WaypointOutcome::kIdle;
  std::size_t count_ = 0, current_ = 0;
  std::vector<std::size_t> missed_;
  std::uint32_t last_leg_ = 0;
  bool under_way_ = false;  ///< the goal `last_leg_` was sent and has not ended
  bool pursued_ = false;    ///< the same, also while the navigation seems to be gone: it may be only hard to hear
  std::optional<Time> up_;  ///< when the navigation was last up
};

}  // namespace frontier_pilot::waypoints
