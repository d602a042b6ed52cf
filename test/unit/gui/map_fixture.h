#pragma once

#include <utility>

#include "gui/controls.h"
#include "gui/map/map_picture.h"
#include "gui_fixture.h"

namespace frontier_pilot::test {

/// A map of that many cells of 10 cm whose lower left corner is the origin, all of them of one value.
inline teleop::MapChange mapOf(int width, int height, std::int8_t value) {
  teleop::MapChange change;
  change.geometry.resolution = 0.1;
  change.geometry.width = width;
  change.geometry.height = height;
  change.rect = change.geometry.rect();
  change.cells.assign(change.geometry.size(), value);
  return change;
}

inline teleop::MapView viewOf(teleop::MapChange change) {
  teleop::MapView view;
  view.change = std::move(change);
  view.scene.frame = "map";
  view.scene.T_map_base = Pose2(1.0, 1.0, 0.0);
  return view;
}

inline teleop::MapChange blockOf(const teleop::MapChange& map, const CellRect& rect, std::int8_t value) {
  teleop::MapChange change{map.geometry, rect, {}};
  change.cells.assign(static_cast<std::size_t>(rect.width) * static_cast<std::size_t>(rect.height), value);
  return change;
}

/// The window with its card of the map, while the navigation is up.
class MapInTheWindow : public PilotWidgetTest {
 protected:
  void SetUp() override {
    PilotWidgetTest::SetUp();
    state_.navigate.server_up = true;
    widget_->setState(state_);
    widget_->resize(1500, 900);
    for (int pass = 0; pass < 3; ++pass) QApplication::processEvents();
  }
  gui::MapPicture& picture() { return *find<gui::MapPicture>("map_picture"); }
  QPoint pixelOf(double x, double y) { return picture().pixelOf({x, y}).toPoint(); }
  QColor colorAt(double x, double y) { return picture().grab().toImage().pixelColor(pixelOf(x, y)); }
  void aimAt(double x, double y, Qt::KeyboardModifiers keys = Qt::NoModifier) {
    QTest::mouseClick(&picture(), Qt::LeftButton, keys, pixelOf(x, y));
  }
  QString message() { return find<gui::ElidedLabel>("map_message")->fullText(); }
};

}  // namespace frontier_pilot::test
