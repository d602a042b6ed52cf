#include "gui/map/map_picture.h"

#include <QPainter>
#include <QPainterPath>

#include "gui/map/map_drawing.h"

namespace frontier_pilot::gui {

MapPicture::MapPicture(const Outline& robot, QWidget* parent) : QWidget(parent), robot_(robot) {
  setObjectName("map_picture");
  setAccessibleName("Map with the robot, its track and the frontiers");
  setToolTip("A double click shows all that is known.");
  setFocusPolicy(Qt::ClickFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setMinimumHeight(emOf(*this) * 9);
}

QSize MapPicture::sizeHint() const {
  const int em = emOf(*this);
  return {em * 14, em * 13};
}

void MapPicture::setView(const teleop::MapView& view) {
  const bool is_replaced = view.scene.replaced != scene_.replaced;
  if (is_replaced || view.scene.frame != scene_.frame) forgetPlaces();
  if (is_replaced) emit aimingEnded();
  if (view.change) {
    // While a place is being chosen, the map stays where it is below the pointer.
    const bool may_move = image_.empty() || (press_ == Press::kNone && !aiming_);
    image_.apply(*view.change);
    if (fitted_ && may_move) fit();
  }
  scene_ = view.scene;
  if (scene_.T_map_base) track_.add(scene_.T_map_base->position());
  update();
}

/// In another frame, and on another map, the same coordinates are another place.
void MapPicture::forgetPlaces() {
  track_.clear();
  press_ = Press::kNone;
  clearWaypoints();
}

void MapPicture::fit() {
  fitted_ = true;
  if (!image_.empty()) viewport_.fit(image_.knownArea());
}

void MapPicture::clearWaypoints() {
  if (waypoints_.empty()) return;
  waypoints_.clear();
  emit waypointsChanged();
  update();
}

void MapPicture::paintEvent(QPaintEvent*) {
  const Theme theme = Theme::current();
  const int em = emOf(*this);
  QPainter painter(this);
  QPainterPath frame;
  frame.addRoundedRect(rect(), em * 0.35, em * 0.35);
  painter.setClipPath(frame);
  painter.fillPath(frame, image_.empty() ? theme.field : MapImage::unknownColor(theme));
  painter.save();
  painter.setTransform(viewport_.transform(), true);
  image_.paint(painter, viewport_.visible(), viewport_.scale(), theme);
  painter.restore();
  painter.setRenderHint(QPainter::Antialiasing);
  const MapDrawing draw(painter, viewport_, theme, em);
  if (!image_.empty()) {
    draw.frontiers(scene_.frontier_cells, image_.geometry().resolution);
    draw.track(track_.points());
    draw.plan(scene_.plan);
    if (scene_.goal) draw.goal(*scene_.goal);
    draw.waypoints(waypoints_);
    if (scene_.T_map_base) draw.robot(robot_, *scene_.T_map_base);
    if (press_ == Press::kGoal || press_ == Press::kWaypoint) draw.goal(aimedPose());
    draw.scaleBar(rect());
  }
  const QString problem = QString::fromStdString(scene_.problem);
  if (!problem.isEmpty()) draw.words(rect(), problem, image_.empty());
}

}  // namespace frontier_pilot::gui
