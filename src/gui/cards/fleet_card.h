#pragma once

#include <string>
#include <vector>

#include "gui/controls.h"
#include "teleop/fleet_view.h"

class QGridLayout;
class QScrollArea;

namespace frontier_pilot::gui {

/// The robots of a fleet at a glance: what each does or why it stands, which one the window shows, and a stop for all.
/// Without a fleet it is hidden.
class FleetCard : public Card {
  Q_OBJECT

 public:
  explicit FleetCard(QWidget* parent = nullptr);
  /// `shown` is the name of the robot that the window shows.
  void setFleet(const teleop::FleetView& fleet, const std::string& shown);

 signals:
  void chosen(const std::string& robot);
  void stopAllAsked();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Row {
    std::string name;
    QWidget* widget;
    Dot* dot;
    QPushButton* choose;
    ElidedLabel* text;
  };

  void rebuild(const std::vector<teleop::RobotView>& robots);
  void layOut(int columns);

  QScrollArea* scroll_;  ///< so that many robots leave room for what is below
  QGridLayout* grid_;
  QPushButton* stop_all_;
  QLabel* answer_;
  std::vector<Row> rows_;
  int columns_ = 0;
};

}  // namespace frontier_pilot::gui
