#pragma once

#include <memory>
#include <optional>
#include <string>

#include "teleop/fleet_view.h"
#include "teleop/operator_link.h"
#include "teleop/parameters.h"

namespace frontier_pilot::teleop {

/// A robot that the window can show.
struct OpenedRobot {
  std::string name;                    ///< empty: the robot in the window's own namespace
  TeleopParameters parameters;         ///< with the robot as it describes itself
  std::unique_ptr<OperatorLink> link;  ///< nothing: it could not be opened
  bool is_described = true;  ///< false: it has not said yet what robot it is, and is taken for one like the window's
};

/// The operator's window's access to several robots, of which it shows one in full. No call waits for a robot or for
/// the master, except `openOwn`. [GUI-3]
class FleetLink {
 public:
  virtual ~FleetLink() = default;

  /// Without a fleet it has no robots. Expected several times a second.
  virtual FleetView fleet() = 0;
  /// The robot in the window's own namespace, for a window that is not on the screen yet: may wait for the master.
  virtual OpenedRobot openOwn() = 0;
  /// Asks for the access to one of the fleet's robots, which `takeOpened` hands over once it is there. While another
  /// one is being opened, the last one that was asked for comes next.
  virtual void open(const std::string& robot) = 0;
  virtual std::optional<OpenedRobot> takeOpened() = 0;
  /// Takes a closed link, which goes on asking for a stop that was pressed, and ends it later.
  virtual void retire(std::unique_ptr<OperatorLink> link) = 0;
  /// Asks again and again for ten seconds that all robots stop, until there is an answer, which `FleetView::stop` has.
  virtual void stopAll() = 0;
  /// The same for one robot, which need not be open. `FleetView::stop` has its answer.
  virtual void stop(const std::string& robot) = 0;
};

}  // namespace frontier_pilot::teleop
