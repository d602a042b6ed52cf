#pragma once

#include <QObject>
#include <map>

class QKeyEvent;
class QTimerEvent;

namespace frontier_pilot::gui {

/// Tells the presses and releases of the operator from those that a window system invents while a key is held. X sends
/// a release and a press with one time stamp for each repetition; Qt marks both as repetitions, but only if it reads
/// the second one together with the first. Otherwise a key that is held through an emergency stop would look like a new
/// press after it was cleared, and move the robot. Each press is followed by one release before the next press of that
/// key. [GUI-1] [GUI-4]
class HeldKeys : public QObject {
  Q_OBJECT

 public:
  /// A release counts after 40 ms in which the key was not pressed again; without a time stamp, at once.
  using QObject::QObject;

  void press(const QKeyEvent& event);
  /// May be told of any key, and more than once: what counts is that of a key that is held, also if a modifier has
  /// given it another letter meanwhile.
  void release(const QKeyEvent& event);

 signals:
  void pressed(int key);
  void released(int key);

 protected:
  void timerEvent(QTimerEvent* event) override;

 private:
  struct Release {
    unsigned long stamp;  ///< [ms]
    int timer;            ///< running as long as it may still turn out to be a repetition; then 0
  };

  /// The release does not wait any more.
  void stopTimer(Release& release);
  int heldKeyOf(const QKeyEvent& event) const;
  void letGo(int key);

  std::map<int, quint32> held_;      ///< the scan codes of the keys whose press has counted; 0: not known
  std::map<int, Release> releases_;  ///< the last one of each key
};

}  // namespace frontier_pilot::gui
