#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <map>
#include <mutex>
#include <string>

namespace frontier_pilot {

/// What would not survive this node, and what of the node before it was lost, for /diagnostics: one place for all that
/// a node keeps. May be used on any thread. [FLT-1] [FLT-2]
class MemoryReport {
 public:
  /// Why `what` would not survive this node; empty: it would.
  void setProblem(const std::string& what, const std::string& problem) { set(problems_, what, problem); }
  /// Why `what` was lost with the node before this one; empty: it was not, or matters no more.
  void setLoss(const std::string& what, const std::string& why) { set(losses_, what, why); }
  /// WARN where something would be lost, ERROR where something was.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  using Reasons = std::map<std::string, std::string>;

  void set(Reasons& reasons, const std::string& what, const std::string& why);

  mutable std::mutex mutex_;  ///< guards what follows
  Reasons problems_, losses_;
};

}  // namespace frontier_pilot
