#pragma once

#include "frontier_pilot/core/outline.h"
#include "gui/controls.h"

namespace frontier_pilot::gui {

/// A drawing of the scan around the robot, with ahead pointing up, and the avoider's sectors coloured by the nearest
/// obstacle in them. The mouse wheel zooms.
class ScanPicture : public QWidget {
  Q_OBJECT

 public:
  explicit ScanPicture(const Outline& robot, QWidget* parent = nullptr);
  void setState(const teleop::OperatorState& state);
  QSize sizeHint() const override;
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override { return qMin(width, sizeHint().height() * 5 / 4); }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  QPointF at(double range, double angle) const;
  void drawRings(QPainter& painter, const Theme& theme) const;
  void drawSector(QPainter& painter, const Theme& theme, const teleop::SectorView& sector,
                  std::optional<double> nearest) const;
  void drawScan(QPainter& painter, const Theme& theme) const;
  void drawRobot(QPainter& painter, const Theme& theme) const;

  Outline robot_;
  double view_radius_ = 2.5;  ///< [m]
  std::optional<teleop::ScanView> scan_;
  std::optional<teleop::AvoiderView> avoider_;
  teleop::AvoiderSectors sectors_;
};

/// The scan around the robot, and the obstacle avoider's state and switch.
class ScanCard : public Card {
  Q_OBJECT

 public:
  explicit ScanCard(const Outline& robot, QWidget* parent = nullptr);
  void setState(const teleop::OperatorState& state);

 signals:
  void avoiderAsked(bool on);

 private:
  ScanPicture* picture_;
  Switch* toggle_;
  Dot* dot_;
  ElidedLabel* text_;
};

}  // namespace frontier_pilot::gui
