#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <cstdint>
#include <exception>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "frontier_pilot/core/time.h"
#include "ros/common/log_interval.h"

namespace frontier_pilot {

/// Catches what a callback throws, so that it ends neither the node nor the thread that called it: exceptions are
/// counted, logged at most every five seconds of steady time for each `what`, and shown in the diagnostics. Safe to use
/// from several threads. [FLT-1]
class CallbackGuard {
 public:
  /// Calls `f`; `what` names the input, such as the topic. Returns whether `f` returned without an exception.
  template <class F>
  bool run(const std::string& what, F&& f) {
    try {
      std::forward<F>(f)();
      return true;
    } catch (const std::exception& error) {
      add(what, error.what());
    } catch (...) {
      add(what, "an exception of unknown type");
    }
    return false;
  }

  /// For an exception that was caught elsewhere; `error` is its text.
  void add(const std::string& what, const std::string& error) noexcept;

  std::uint64_t total() const;
  /// Adds the count and the latest text for each `what`, and a warning to the summary while the latest exception is
  /// younger than ten seconds.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  struct Caught {
    std::uint64_t count = 0;
    std::string latest;  ///< its text
    LogInterval log_interval;
  };

  mutable std::mutex mutex_;
  std::uint64_t total_ = 0;
  SteadyTime latest_{};
  std::map<std::string, Caught> caught_;  ///< by input (`what`)
};

}  // namespace frontier_pilot
