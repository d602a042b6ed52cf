#pragma once

#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "teleop/operator_state.h"

namespace frontier_pilot::teleop {

/// Something that the operator wants of the system.
struct OperatorRequest {
  enum class Kind {
    kEmergencyStop,
    kClearEmergencyStop,
    kEnableSource,   ///< `name`, `on`
    kEnableAvoider,  ///< `on`
    kExplore,        ///< `on`: go on or pause
    kResetExplorer,
    kPatrol,  ///< `shape`, `side` [m], `laps`
    kStopPatrol,
    kSpin,  ///< `angle`
    kStopSpin,
  };
  Kind kind = Kind::kEmergencyStop;
  bool on = false;
  std::string name;
  int shape = 0;  ///< as in Patrol.action: 1 square, 2 triangle, 3 circle
  double side = 0.0;
  int laps = 0;
  double angle = 0.0;  ///< [rad], positive is to the left
};

/// A line for the operator's log.
struct OperatorLogLine {
  Severity severity = Severity::kIdle;
  std::string text;
};

/// The robot as the window sees it. No call of it ever blocks: requests are carried out elsewhere, and what became of
/// them is in the log and in the next state. [GUI-3]
class OperatorLink {
 public:
  virtual ~OperatorLink() = default;

  virtual OperatorState state() = 0;
  /// The window lives, and this is its set-point. Expected every 50 ms.
  virtual void beat(const Twist2& set_point) = 0;
  virtual void request(const OperatorRequest& request) = 0;
  /// The lines since the last call.
  virtual std::vector<OperatorLogLine> takeLog() = 0;
  /// False when the system wants the window to close.
  virtual bool running() const = 0;
  /// The window closes: sends zero and cancels what it has started. Nothing moves by it afterwards.
  virtual void close() = 0;
};

}  // namespace frontier_pilot::teleop
