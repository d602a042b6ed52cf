#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "gui/map/map_picture.h"

/// What the pointer and the keys do on the map.
namespace frontier_pilot::gui {
namespace {

constexpr double kLeastDrag = 8.0;  // a shorter one sets no direction [px]
constexpr std::size_t kMostWaypoints = 100;

double length(const QPointF& offset) { return std::hypot(offset.x(), offset.y()); }

}  // namespace

void MapPicture::setAiming(bool aiming) {
  aiming_ = aiming;
  if (!aiming && press_ == Press::kGoal) press_ = Press::kNone;
  setCursor(aiming ? Qt::CrossCursor : Qt::ArrowCursor);
  update();
}

void MapPicture::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  viewport_.setSize(size());
  if (fitted_) fit();
}

void MapPicture::wheelEvent(QWheelEvent* event) {
  fitted_ = false;
  viewport_.zoom(std::pow(1.0015, event->angleDelta().y()), event->position());
  event->accept();
  update();
}

void MapPicture::mousePressEvent(QMouseEvent* event) {
  if (press_ != Press::kNone && event->button() != button_) return;
  button_ = event->button();
  pressed_at_ = pointer_ = event->localPos();
  pressed_place_ = viewport_.place(pressed_at_);
  press_ = Press::kMove;
  if (event->button() != Qt::LeftButton) return;
  const bool waypoint = (event->modifiers() & Qt::ShiftModifier) != 0;
  if (!waypoint && !aiming_) return;
  const QString why = whyNot(pressed_place_);
  press_ = !why.isEmpty() ? Press::kNone : (waypoint ? Press::kWaypoint : Press::kGoal);
  if (!why.isEmpty()) emit refused(why);
  update();
}

void MapPicture::mouseMoveEvent(QMouseEvent* event) { follow(event->localPos()); }

void MapPicture::follow(const QPointF& pointer) {
  const QPointF moved = pointer - std::exchange(pointer_, pointer);
  if (press_ == Press::kNone || moved.isNull()) return;
  if (press_ == Press::kMove) {
    fitted_ = false;
    viewport_.drag(moved);
  }
  update();
}

void MapPicture::mouseReleaseEvent(QMouseEvent* event) {
  follow(event->localPos());
  if (event->button() != button_) return;
  const Pose2 pose = aimedPose();
  const Press press = std::exchange(press_, Press::kNone);
  if (press == Press::kGoal || press == Press::kWaypoint) choose(pose, press);
  update();
}

void MapPicture::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->modifiers() != Qt::NoModifier || aiming_) return mousePressEvent(event);
  fit();
  update();
}

void MapPicture::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
  press_ = Press::kNone;
  emit aimingEnded();
  update();
}

/// Where it was pressed, in the direction of the drag; without a drag, in that of the way from the robot or from the
/// waypoint before.
Pose2 MapPicture::aimedPose() const {
  const Vec2& place = pressed_place_;
  const QPointF drag = pointer_ - pressed_at_;
  if (length(drag) >= kLeastDrag) return {place, std::atan2(-drag.y(), drag.x())};
  std::optional<Vec2> from;
  if (scene_.T_map_base) from = scene_.T_map_base->position();
  if (press_ == Press::kWaypoint && !waypoints_.empty()) from = waypoints_.back().position();
  return {place, from && *from != place ? bearing(place - *from) : 0.0};
}

QString MapPicture::whyNot(const Vec2& place) const {
  if (image_.empty()) return "there is no map yet";
  const GridGeometry& geometry = image_.geometry();
  const QRectF map(geometry.origin.x(), geometry.origin.y(), geometry.width * geometry.resolution,
                   geometry.height * geometry.resolution);
  // Far outside of it, a place has no cell. Its right and its upper edge belong to no cell of the map.
  const Cell cell = map.contains(place.x(), place.y()) ? geometry.cellAt(place) : Cell{-1, -1};
  if (!geometry.contains(cell)) return "that is outside of the map";
  const std::int8_t value = image_.at(cell);
  if (isUnknown(value)) return "nothing is known of that place yet";
  return isFree(value) ? QString() : QString("there is an obstacle");
}

void MapPicture::choose(const Pose2& pose, Press press) {
  if (press == Press::kGoal) return emit goalChosen(pose);
  if (waypoints_.size() >= kMostWaypoints) return emit refused("that would be more than 100 waypoints");
  waypoints_.push_back(pose);
  emit waypointsChanged();
}

}  // namespace frontier_pilot::gui
