#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <map>
#include <mutex>
#include <string>

#include "frontier_pilot/core/time.h"
#include "ros/common/clock.h"

namespace frontier_pilot {

/// For /diagnostics: which data would not survive the death of this node, and which data of the process before it was
/// lost. Safe to use from several threads. [FLT-1] [FLT-2]
class MemoryReport {
 public:
  /// Why `what` would not survive this node; empty if it would. That the disk does not answer counts once it has been
  /// so for five seconds: on a busy computer a single write comes late. Returns the problem that counts.
  std::string setProblem(const std::string& what, const std::string& problem, SteadyTime now = steadyNow());
  /// Why `what` was lost with the process before this one; empty if it was not, or if it does not matter any more.
  void setLoss(const std::string& what, const std::string& why);
  /// WARN if something would be lost, ERROR if something was lost.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  using Reasons = std::map<std::string, std::string>;

  static void set(Reasons& reasons, const std::string& what, const std::string& why);

  mutable std::mutex mutex_;  ///< guards what follows
  Reasons problems_, losses_;
  std::map<std::string, SteadyTime> silent_since_;  ///< since when the disk has not answered, for each of what is kept
};

}  // namespace frontier_pilot
