#include "gui/map/map_drawing.h"

#include <algorithm>
#include <cmath>

namespace frontier_pilot::gui {

MapDrawing::MapDrawing(QPainter& painter, const MapViewport& viewport, const Theme& theme, int em)
    : painter_(painter), viewport_(viewport), theme_(theme), em_(em) {}

QPolygonF MapDrawing::pixels(const std::vector<Vec2>& points) const {
  QPolygonF out;
  out.reserve(static_cast<int>(points.size()));
  for (const Vec2& point : points) {
    const QPointF pixel = viewport_.pixel(point);
    // Points that fall onto the same pixel cost time and show nothing.
    if (out.isEmpty() || (pixel - out.back()).manhattanLength() >= 1.0) out << pixel;
  }
  return out;
}

void MapDrawing::frontiers(const std::vector<Vec2>& cells, double resolution) const {
  const double side = std::max(resolution * viewport_.scale(), em_ * 0.15);
  painter_.setRenderHint(QPainter::Antialiasing, false);
  const QRectF visible = viewport_.visible();
  for (const Vec2& cell : cells) {
    if (!visible.contains(cell.x(), cell.y())) continue;
    const QPointF middle = viewport_.pixel(cell);
    painter_.fillRect(QRectF(middle.x() - 0.5 * side, middle.y() - 0.5 * side, side, side), theme_.good);
  }
  painter_.setRenderHint(QPainter::Antialiasing);
}

void MapDrawing::track(const std::vector<Vec2>& points) const {
  painter_.setPen(QPen(faded(theme_.warning, 0.75), std::max(1.0, em_ * 0.09)));
  painter_.drawPolyline(pixels(points));
}

void MapDrawing::plan(const std::vector<Vec2>& points) const {
  painter_.setPen(QPen(theme_.accent, std::max(1.5, em_ * 0.13), Qt::DashLine));
  painter_.drawPolyline(pixels(points));
}

void MapDrawing::robot(const Outline& outline, const Pose2& pose) const {
  // Drawn larger when the view is so wide that the robot would be a dot.
  const double least = em_ * 0.55 / outline.circumscribedRadius();
  const double scale = std::max(viewport_.scale(), least);
  const QPointF origin = viewport_.pixel(pose.position());
  const auto at = [&](const Vec2& in_base) {
    const Vec2 turned = Rotation2(pose.yaw) * in_base;
    return origin + QPointF(turned.x(), -turned.y()) * scale;
  };
  QPolygonF body, nose;
  for (const Vec2& corner : outline.corners()) body << at(corner);
  const double half = 0.5 * std::min(outline.front() + outline.rear(), 2.0 * outline.halfWidth());
  const double middle = 0.5 * (outline.front() - outline.rear());
  for (const Vec2& corner : {Vec2(middle + 0.7 * half, 0.0), Vec2(middle - 0.45 * half, -0.5 * half),
                             Vec2(middle - 0.45 * half, 0.5 * half)}) {
    nose << at(corner);
  }
  painter_.setPen(QPen(theme_.card, 1.5));
  painter_.setBrush(theme_.accent);
  painter_.drawPolygon(body);
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(theme_.on_accent);
  painter_.drawPolygon(nose);
  painter_.setBrush(Qt::NoBrush);
}

void MapDrawing::goal(const Pose2& pose) const { pin(pose, theme_.danger, {}); }

void MapDrawing::waypoints(const std::vector<Pose2>& poses) const {
  std::vector<Vec2> points;
  for (const Pose2& pose : poses) points.push_back(pose.position());
  painter_.setPen(QPen(faded(theme_.danger, 0.5), std::max(1.0, em_ * 0.08), Qt::DotLine));
  painter_.drawPolyline(pixels(points));
  for (std::size_t i = 0; i < poses.size(); ++i) pin(poses[i], theme_.danger, QString::number(i + 1));
}

/// A disc with a name, and a line in the direction of the pose.
void MapDrawing::pin(const Pose2& pose, const QColor& color, const QString& name) const {
  const QPointF centre = viewport_.pixel(pose.position());
  const double radius = em_ * (name.isEmpty() ? 0.28 : 0.5), reach = em_ * 1.1;
  painter_.setPen(QPen(color, std::max(1.5, em_ * 0.13), Qt::SolidLine, Qt::RoundCap));
  painter_.drawLine(centre, centre + QPointF(std::cos(pose.yaw), -std::sin(pose.yaw)) * reach);
  painter_.setPen(QPen(theme_.card, 1.0));
  painter_.setBrush(color);
  painter_.drawEllipse(centre, radius, radius);
  painter_.setBrush(Qt::NoBrush);
  if (name.isEmpty()) return;
  QFont small = painter_.font();
  small.setPixelSize(std::max(6, static_cast<int>(em_ * 0.6)));
  small.setBold(true);
  painter_.save();
  painter_.setFont(small);
  painter_.setPen(theme_.dark ? theme_.window : QColor(Qt::white));
  painter_.drawText(QRectF(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius), Qt::AlignCenter, name);
  painter_.restore();
}

void MapDrawing::scaleBar(const QRect& area) const {
  const double longest = 0.28 * area.width() / viewport_.scale();
  const double decade = std::pow(10.0, std::floor(std::log10(longest)));
  const double length = longest >= 5.0 * decade ? 5.0 * decade : (longest >= 2.0 * decade ? 2.0 * decade : decade);
  const QPointF left(area.left() + em_ * 0.6, area.bottom() - em_ * 0.6);
  const QPointF right = left + QPointF(length * viewport_.scale(), 0.0);
  const QPointF tick(0.0, em_ * 0.25);
  painter_.setPen(QPen(theme_.text, std::max(1.0, em_ * 0.09)));
  painter_.drawLine(left, right);
  painter_.drawLine(left - tick, left);
  painter_.drawLine(right - tick, right);
  painter_.drawText(left + QPointF(em_ * 0.2, -em_ * 0.25), QString("%1 m").arg(length));
}

void MapDrawing::words(const QRect& area, const QString& text, bool in_the_middle) const {
  const QRect room = area.adjusted(em_, em_ / 2, -em_, -em_ / 2);
  const Qt::Alignment place = Qt::AlignHCenter | (in_the_middle ? Qt::AlignVCenter : Qt::AlignTop);
  const int flags = static_cast<int>(place) | static_cast<int>(Qt::TextWordWrap);
  const QRect box = painter_.boundingRect(room, flags, text);
  if (!in_the_middle) {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(faded(theme_.card, 0.88));
    painter_.drawRoundedRect(box.adjusted(-em_ / 3, -em_ / 6, em_ / 3, em_ / 6), em_ * 0.25, em_ * 0.25);
    painter_.setBrush(Qt::NoBrush);
  }
  painter_.setPen(in_the_middle ? theme_.muted : theme_.warning);
  painter_.drawText(room, flags, text);
}

}  // namespace frontier_pilot::gui
