#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "frontier_pilot/core/outline.h"
#include "gui/map/map_image.h"
#include "gui/map/map_viewport.h"
#include "teleop/map_view.h"
#include "teleop/track.h"

namespace frontier_pilot::gui {

/// A drawing of the map with the robot, its track, the frontiers, the goal and the plan. The wheel zooms, a drag moves
/// the map, and a double click shows all of it again.
///
/// With setAiming a press chooses a goal and a drag from there its direction; with the Shift key it adds a waypoint.
/// Places that are not known to be free are refused, in words. Escape ends the choice. Nothing here sends anything.
class MapPicture : public QWidget {
  Q_OBJECT

 public:
  explicit MapPicture(const Outline& robot, QWidget* parent = nullptr);

  /// Only what has changed in the map is drawn into its image again. If the frame of the map has changed, or another
  /// map has come in place of this one, the track, the waypoints and a press in progress are dropped; in the second
  /// case the choice of a goal ends, too.
  void setView(const teleop::MapView& view);
  /// Whether the next press of the left button chooses a goal. Ending it drops a press that was to become one.
  void setAiming(bool aiming);
  const std::vector<Pose2>& waypoints() const { return waypoints_; }
  void clearWaypoints();
  const teleop::MapScene& scene() const { return scene_; }
  const MapImage& image() const { return image_; }
  /// The pixel at which a place of the map is drawn.
  QPointF pixelOf(const Vec2& place) const { return viewport_.pixel(place); }
  QSize sizeHint() const override;

 signals:
  /// The operator has chosen a goal, in the map's frame.
  void goalChosen(const frontier_pilot::Pose2& goal);
  void waypointsChanged();
  /// Why the place that was chosen is no goal.
  void refused(const QString& why);
  /// The choice of a goal was ended, with Escape or because another map has come.
  void aimingEnded();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Press { kNone, kMove, kGoal, kWaypoint };

  void forgetPlaces();
  void fit();
  void follow(const QPointF& pointer);
  /// Why the robot cannot be sent to the place; empty if it may be.
  QString whyNot(const Vec2& place) const;
  Pose2 aimedPose() const;
  void choose(const Pose2& pose, Press press);

  const Outline robot_;
  MapImage image_;
  MapViewport viewport_;
  teleop::MapScene scene_;
  teleop::Track track_;
  std::vector<Pose2> waypoints_;
  bool fitted_ = true;  ///< the view follows the size of the map until it is zoomed or moved
  bool aiming_ = false;
  Press press_ = Press::kNone;
  Qt::MouseButton button_ = Qt::NoButton;  ///< of the last press; others are ignored while it lasts
  QPointF pressed_at_, pointer_;           ///< [px]
  Vec2 pressed_place_ = Vec2::Zero();      ///< where on the map it was pressed: the view may be zoomed meanwhile
};

}  // namespace frontier_pilot::gui
