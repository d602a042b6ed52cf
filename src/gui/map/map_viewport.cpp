#include "gui/map/map_viewport.h"

#include <algorithm>

namespace frontier_pilot::gui {
namespace {

constexpr double kLeastScale = 1e-3, kGreatestScale = 1000.0;  // [pixels/m]
constexpr double kMargin = 0.94;                               // the share of the widget that a fitted area fills
constexpr double kLeastSide = 2.0;                             // of a fitted area [m]

}  // namespace

void MapViewport::fit(const QRectF& area) {
  centre_ = Vec2(area.center().x(), area.center().y());
  const double across = size_.width() / std::max(area.width(), kLeastSide);
  const double along = size_.height() / std::max(area.height(), kLeastSide);
  scale_ = std::clamp(kMargin * std::min(across, along), kLeastScale, kGreatestScale);
}

void MapViewport::zoom(double factor, const QPointF& pixel) {
  const Vec2 before = place(pixel);
  scale_ = std::clamp(scale_ * factor, kLeastScale, kGreatestScale);
  centre_ += before - place(pixel);
}

void MapViewport::drag(const QPointF& pixels) { centre_ += Vec2(-pixels.x(), pixels.y()) / scale_; }

Vec2 MapViewport::place(const QPointF& pixel) const {
  return centre_ + Vec2(pixel.x() - 0.5 * size_.width(), 0.5 * size_.height() - pixel.y()) / scale_;
}

QPointF MapViewport::pixel(const Vec2& place) const {
  const Vec2 offset = (place - centre_) * scale_;
  return {0.5 * size_.width() + offset.x(), 0.5 * size_.height() - offset.y()};
}

QRectF MapViewport::visible() const {
  const Vec2 half(0.5 * size_.width() / scale_, 0.5 * size_.height() / scale_);
  return {centre_.x() - half.x(), centre_.y() - half.y(), 2.0 * half.x(), 2.0 * half.y()};
}

QTransform MapViewport::transform() const {
  const QPointF origin = pixel(Vec2::Zero());
  return {scale_, 0.0, 0.0, -scale_, origin.x(), origin.y()};
}

}  // namespace frontier_pilot::gui
