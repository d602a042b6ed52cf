#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/core/time.h"
#include "robot_check/observation.h"
#include "ros/common/inputs/start_grace.h"

namespace frontier_pilot {

/// Whether a node has all its inputs, and if not what it waits for, in the same words in the log, in the diagnostics
/// and wherever else the node shows its state. For the thread that runs the callbacks. [ROB-3]
class InputWatch {
 public:
  using Topics = std::vector<robot_check::Topic>;
  /// Says what is missing and under which other name it is there; empty if it is there. `topics` is what the master
  /// knows, and empty before its first answer.
  using Missing = std::function<std::string(const Topics& topics)>;

  void need(Missing missing) { needs_.push_back(std::move(missing)); }
  bool needsSomething() const { return !needs_.empty(); }

  /// Looks whether all inputs are there. To be called every second; logs what is missing after two seconds and then
  /// every ten, as WARN unless the looks have only begun, and when all are there.
  void look(const Topics& topics, SteadyTime now);
  /// What is missing as of the last look, in words; empty if nothing is, or if there was no look yet.
  const std::string& missing() const { return missing_; }
  bool ready() const { return looked_ && missing_.empty(); }
  /// For /diagnostics: WARN from when the log has said what is missing, until nothing is.
  void report(diagnostic_updater::DiagnosticStatusWrapper& status) const;

 private:
  std::vector<Missing> needs_;
  bool looked_ = false;
  std::optional<StartGrace> grace_;  ///< from the first look on
  std::string missing_;
  std::optional<SteadyTime> since_;  ///< when something was first missing; none while all is there
  std::optional<SteadyTime> said_;
};

}  // namespace frontier_pilot
