#pragma once

#include "gui/controls.h"
#include "gui/map/map_picture.h"
#include "teleop/operator_link.h"

namespace frontier_pilot::gui {

/// The map: where on it the robot is sent, and what becomes of it.
class MapCard : public Card {
  Q_OBJECT

 public:
  explicit MapCard(const Outline& robot, QWidget* parent = nullptr);
  void setState(const teleop::OperatorState& state);
  void setView(const teleop::MapView& view);
  /// What was asked for here last is not done, because the window was frozen.
  void sayNotDone();

 signals:
  void goAsked(const frontier_pilot::Pose2& goal);
  void waypointsAsked(const std::vector<frontier_pilot::Pose2>& poses);
  void returnAsked();
  /// `path` without extension.
  void saveAsked(const QString& path);
  void loadAsked(const QString& path);

 private:
  QLayout* makeButtons();
  /// Shows on the buttons how many waypoints there are.
  void showWaypointCount();
  void showWaypoints(const teleop::OperatorState& state);
  /// Asks for a file without keeping the window from being used: its emergency stop has to work meanwhile.
  void askForFile(bool to_save);
  void connectPicture();
  /// Begins or ends the choice of a goal.
  void aim(bool on);
  void say(const QString& text, teleop::Severity severity);

  MapPicture* picture_;
  QPushButton* go_;
  QPushButton* follow_;
  QPushButton* forget_;
  QPushButton* return_;
  QPushButton* save_;
  QPushButton* load_;
  std::uint64_t answers_ = 0;  ///< that have been shown
  bool follower_up_ = false;   ///< the node that follows the waypoints
  bool stopped_ = false;       ///< the emergency stop is latched
  std::string waypoints_told_;
  Dot* dot_;
  ElidedLabel* message_;
};

}  // namespace frontier_pilot::gui
