#pragma once

#include <QWidget>
#include <cstdint>
#include <string>
#include <vector>

#include "teleop/drive_model.h"
#include "teleop/operator_link.h"

class QBoxLayout;
class QKeyEvent;
class QVBoxLayout;

namespace frontier_pilot::gui {

class DriveCard;
class ExplorerCard;
class HeaderCard;
class HeldKeys;
class LogCard;
class MapCard;
class NavigationCard;
class PatrolCard;
class ScanCard;
class SourcesCard;
class SpinCard;

/// The content of the operator's window, on the desktop and in rviz alike.
///
/// State comes in as plain data, requests go out as signals; nothing here uses ROS, waits or blocks. A control always
/// shows the state that the system last reported, never the click. The cards are laid out in one to four columns.
class PilotWidget : public QWidget {
  Q_OBJECT

 public:
  explicit PilotWidget(const teleop::TeleopParameters& parameters, QWidget* parent = nullptr);
  ~PilotWidget() override;

  void setState(const teleop::OperatorState& state);
  void setMap(const teleop::MapView& view);
  void appendLog(const teleop::OperatorLogLine& line);
  /// The request was made while the window was frozen, or just after it.
  void sayNotDone(const teleop::OperatorRequest& request);
  /// The manual set-point, in the base frame.
  Twist2 setPoint() const { return drive_.setPoint(); }
  /// Zeroes the set-point and logs the reason. A clear that was still to come is not made.
  void stopBecause(const std::string& reason);

 signals:
  /// The operator has requested something of the system.
  void requested(const frontier_pilot::teleop::OperatorRequest& request);
  /// The set-point has changed and has to be sent without waiting for the next beat.
  void setPointChanged(const frontier_pilot::Twist2& set_point);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  static constexpr int kMostColumns = 4;

  void build();
  void connectCards();
  void connectKeys();
  void connectMap();
  std::vector<std::vector<QWidget*>> planOf(int columns) const;
  void layOut(int columns);
  void press(teleop::Motion motion);
  void release(teleop::Motion motion);
  void letGo();
  void loseSight();
  void haltAndClear();
  void goOnClearing(const teleop::OperatorState& state);
  void send(const teleop::OperatorRequest& request);
  void showCards(const teleop::OperatorState& state);
  void showSetPoint();
  bool isInDialog(const QWidget* widget) const;
  bool handleKey(QWidget& focus, QKeyEvent& event);

  teleop::TeleopParameters parameters_;
  teleop::DriveModel drive_;
  teleop::OperatorState last_state_;
  Twist2 shown_;
  int columns_ = 0;
  int refreshes_to_clear_ = 0, clears_left_ = 0;  ///< of a halt after which the stop is to be cleared
  std::uint64_t stops_to_clear_ = 0;              ///< how many had been asked for by then
  HeldKeys* keys_ = nullptr;
  std::vector<QVBoxLayout*> column_layouts_;
  QBoxLayout* body_ = nullptr;
  HeaderCard* header_ = nullptr;
  DriveCard* drive_card_ = nullptr;
  ScanCard* scan_card_ = nullptr;
  MapCard* map_card_ = nullptr;
  SourcesCard* sources_card_ = nullptr;
  PatrolCard* patrol_card_ = nullptr;
  SpinCard* spin_card_ = nullptr;
  NavigationCard* navigation_card_ = nullptr;
  ExplorerCard* explorer_card_ = nullptr;
  LogCard* log_card_ = nullptr;
};

}  // namespace frontier_pilot::gui
