#pragma once

#include <QPointF>
#include <QRectF>
#include <QSize>
#include <QTransform>

#include "frontier_pilot/core/geometry.h"

namespace frontier_pilot::gui {

/// Which part of the map a widget shows: x to the right, y up. Lengths in the map's frame [m], and in pixels.
class MapViewport {
 public:
  void setSize(const QSize& size) { size_ = size; }
  /// Shows all of `area`, in the middle and with some margin.
  void fit(const QRectF& area);
  /// Zooms by `factor` while the place under `pixel` stays where it is.
  void zoom(double factor, const QPointF& pixel);
  /// Moves what is shown along with the pointer.
  void drag(const QPointF& pixels);

  double scale() const { return scale_; }  ///< [pixels/m]
  Vec2 place(const QPointF& pixel) const;
  QPointF pixel(const Vec2& place) const;
  /// The part of the plane that is visible.
  QRectF visible() const;
  /// From the map's frame to pixels.
  QTransform transform() const;

 private:
  QSize size_{1, 1};
  Vec2 centre_ = Vec2::Zero();
  double scale_ = 50.0;
};

}  // namespace frontier_pilot::gui
