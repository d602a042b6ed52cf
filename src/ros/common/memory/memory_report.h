#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <map>
#include <mutex>
#include <string>

namespace frontier_pilot {

/// For /diagnostics: which data would not survive the death of this node, and which data of the process before it was
/// lost. Safe to use from several threads. [FLT-1] [FLT-2]
class MemoryReport {
 public:
  /// Why `what` would not survive this node; empty if it would.
  void setProblem(const std::string& what, const std::string& problem) { set(problems_, what, problem); }
  /// Why `what` was lost with the process before this one; empty if it was not, or if it does not matter any more.
  void setLoss(const std::string& what, const std::string& why) { set(losses_, what, why); }
  /// WARN if something would be lost, ERROR if something was lost.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  using Reasons = std::map<std::string, std::string>;

  void set(Reasons& reasons, const std::string& what, const std::string& why);

  mutable std::mutex mutex_;  ///< guards what follows
  Reasons problems_, losses_;
};

}  // namespace frontier_pilot
