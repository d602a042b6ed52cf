#pragma once

#include <QPainter>
#include <vector>

#include "frontier_pilot/core/outline.h"
#include "gui/map/map_viewport.h"
#include "gui/theme.h"

/// What is drawn over the cells of a map.
namespace frontier_pilot::gui {

/// Draws in pixels; places are those of the map's frame [m].
class MapDrawing {
 public:
  /// `em` is the height of a line [px].
  MapDrawing(QPainter& painter, const MapViewport& viewport, const Theme& theme, int em);

  void frontiers(const std::vector<Vec2>& cells, double resolution) const;
  void track(const std::vector<Vec2>& points) const;
  void plan(const std::vector<Vec2>& points) const;
  void robot(const Outline& outline, const Pose2& pose) const;
  void goal(const Pose2& pose) const;
  /// Numbered in their order.
  void waypoints(const std::vector<Pose2>& poses) const;
  /// How long a round number of metres is, in the lower left corner.
  void scaleBar(const QRect& area) const;
  /// Words at the upper edge, or in the middle where there is no map.
  void words(const QRect& area, const QString& text, bool in_the_middle) const;

 private:
  QPolygonF pixels(const std::vector<Vec2>& points) const;
  void pin(const Pose2& pose, const QColor& color, const QString& name) const;

  QPainter& painter_;
  const MapViewport& viewport_;
  const Theme& theme_;
  int em_;
};

}  // namespace frontier_pilot::gui
