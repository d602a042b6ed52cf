#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "frontier_pilot/arbiter/arbiter.h"

namespace frontier_pilot {

/// The rules of ARB-1 to ARB-9 said again, slowly and obviously: it keeps the history of each source and reads it from
/// the latest entry backward each time it is asked. It shares no code with the arbiter.
class ArbiterModel {
 public:
  explicit ArbiterModel(const arbiter::ArbiterParameters& parameters)
      : parameters_(parameters), sources_(parameters.sources.size()) {
    for (std::size_t i = 0; i < sources_.size(); ++i) sources_[i].enabled = parameters.sources[i].enabled;
  }

  void timePasses(const Instant& now) {
    if (seen_ && now.ros == last_ros_) {
      standing_ = now.steady - moved_ >= std::chrono::milliseconds(500);
      if (standing_) erase();
      return;
    }
    if (seen_ && now.ros < last_ros_) erase();
    seen_ = true;
    standing_ = false;
    last_ros_ = now.ros;
    moved_ = now.steady;
  }
  void message(std::size_t source, const Twist2& twist, bool hold, const Instant& now) {
    timePasses(now);
    Source& s = sources_[source];
    const bool finite = std::isfinite(twist.linear) && std::isfinite(twist.angular);
    if (finite && (twist.linear != 0.0 || twist.angular != 0.0)) s.moved_at = now.steady;
    if (finite && s.enabled && !standing_) s.history.push_back({twist, hold, now.ros});
    if (!finite) s.history.clear();
  }
  void enable(std::size_t source, bool on, const Instant& now) {
    timePasses(now);
    if (sources_[source].enabled != on) sources_[source].history.clear();
    sources_[source].enabled = on;
  }
  void stop(const Instant& now) {
    timePasses(now);
    latched_ = true;
    stopped_at_ = now.steady;
  }
  bool clear(SteadyTime called, const Instant& now) {
    timePasses(now);
    if (!latched_) return true;
    if (stopped_at_ >= called) return false;
    for (const Source& s : sources_) {
      if (s.enabled && s.moved_at && now.steady - *s.moved_at <= std::chrono::milliseconds(500)) return false;
    }
    erase();
    latched_ = false;
    return true;
  }

  bool latched() const { return latched_; }

  /// What must be on the wheels at `now`, and by whom (an index, or -1).
  Twist2 wheels(Time now, int* driver = nullptr) const {
    if (driver != nullptr) *driver = -1;
    if (latched_ || standing_) return {};
    const int winner = topClaimant(now);
    if (driver != nullptr) *driver = winner;
    if (winner < 0) return {};
    Twist2 twist = fresh(static_cast<std::size_t>(winner), now).value();
    twist.linear =
        std::fmin(std::fmax(twist.linear, -parameters_.robot.limits.max_linear), parameters_.robot.limits.max_linear);
    twist.angular = std::fmin(std::fmax(twist.angular, -parameters_.robot.limits.max_angular),
                              parameters_.robot.limits.max_angular);
    if (someoneRequiredIsSilentAbove(winner, now) && twist.linear > 0.0) twist.linear = 0.0;
    return twist;
  }

 private:
  struct Message {
    Twist2 twist;
    bool hold;
    Time at;
  };
  struct Source {
    bool enabled = true;
    std::vector<Message> history;
    std::optional<SteadyTime> moved_at;
  };

  void erase() {
    for (Source& s : sources_) s.history.clear();
  }
  std::optional<Twist2> fresh(std::size_t source, Time now) const {
    const Source& s = sources_[source];
    if (!s.enabled || s.history.empty()) return std::nullopt;
    if (toSeconds(now - s.history.back().at) > parameters_.sources[source].timeout) return std::nullopt;
    return s.history.back().twist;
  }
  bool claims(std::size_t source, Time now) const {
    const std::optional<Twist2> twist = fresh(source, now);
    if (!twist) return false;
    const bool zero = twist->linear == 0.0 && twist->angular == 0.0;
    const bool idles = zero && !sources_[source].history.back().hold;
    return !(idles && parameters_.sources[source].zero_means_idle);
  }
  int topClaimant(Time now) const {
    int best = -1;
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const bool higher =
          best < 0 || parameters_.sources[i].priority > parameters_.sources[static_cast<std::size_t>(best)].priority;
      if (claims(i, now) && higher) best = static_cast<int>(i);
    }
    return best;
  }
  bool someoneRequiredIsSilentAbove(int winner, Time now) const {
    const int priority = parameters_.sources[static_cast<std::size_t>(winner)].priority;
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const arbiter::SourceParameters& p = parameters_.sources[i];
      if (p.required && p.priority > priority && sources_[i].enabled && !fresh(i, now)) return true;
    }
    return false;
  }

  arbiter::ArbiterParameters parameters_;
  std::vector<Source> sources_;
  bool seen_ = false, standing_ = false, latched_ = false;
  Time last_ros_;
  SteadyTime moved_, stopped_at_;
};

}  // namespace frontier_pilot
