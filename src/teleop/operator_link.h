#pragma once

#include <string>
#include <vector>

#include "frontier_pilot/core/geometry.h"
#include "teleop/map_view.h"
#include "teleop/operator_state.h"

namespace frontier_pilot::teleop {

/// A request of the operator.
struct OperatorRequest {
  enum class Kind {
    kEmergencyStop,
    kClearEmergencyStop,
    kEnableSource,   ///< `name`, `on`
    kEnableAvoider,  ///< `on`
    kExplore,        ///< `on`: explore, or pause
    kResetExplorer,
    kClearBounds,
    kClearInspections,
    kReturnToStart,  ///< `on`
    kPatrol,         ///< `shape`, `side` [m], `laps`
    kStopPatrol,
    kSpin,  ///< `angle`
    kStopSpin,
    kStopNavigation,
    kGoTo,             ///< the only one of `poses`
    kFollowWaypoints,  ///< `poses` in their order
    kSaveMap,          ///< `name`: its path without extension
    kLoadMap,          ///< `name`: its path
  };
  Kind kind = Kind::kEmergencyStop;
  bool on = false;
  std::string name;
  int shape = 0;  ///< as in Patrol.action: 1 square, 2 triangle, 3 circle
  double side = 0.0;
  int laps = 0;
  double angle = 0.0;          ///< [rad], positive is to the left
  std::vector<Pose2> poses{};  ///< in the frame of the map
};

/// A line for the operator's log.
struct OperatorLogLine {
  Severity severity = Severity::kIdle;
  std::string text;
};

/// The operator's window's access to the robot. No call ever blocks: requests are carried out asynchronously, and their
/// results appear in the log and in the next state. [GUI-3]
class OperatorLink {
 public:
  virtual ~OperatorLink() = default;

  /// The time by which a window that does not respond is noticed. It goes on while the computer is suspended: whoever
  /// opens the lid again has let go of the robot meanwhile.
  virtual SteadyTime now() const = 0;
  virtual OperatorState state() = 0;
  /// The window's heartbeat, with its set-point. Expected every 50 ms.
  virtual void beat(const Twist2& set_point) = 0;
  virtual void request(const OperatorRequest& request) = 0;
  /// The map, with what has changed in it since the last call. Expected at most five times a second.
  virtual MapView takeMap() = 0;
  /// The lines since the last call.
  virtual std::vector<OperatorLogLine> takeLog() = 0;
  /// False when the system wants the window to close.
  virtual bool running() const = 0;
  /// To be called when the window closes: sends zero and cancels what it has started. It commands no motion afterwards.
  virtual void close() = 0;
};

}  // namespace frontier_pilot::teleop
