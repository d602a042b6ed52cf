#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot::gui {

/// Says while the window of a widget cannot be seen, as far as the X server knows: a window manager may unmap its
/// frame, because the window is on another workspace or behind a tab, without a word that Qt passes on. A window that
/// another one covers is not reported, nor is anything where Qt draws without an X server. Never waits for the server:
/// one that owes an answer for longer than `patience`, as over a network that stalls, does not hear of a key that is
/// let go either, and counts as one that does not show the window. [GUI-4]
class WindowWatch : public QObject {
  Q_OBJECT

 public:
  /// Watches the window that `content` is in, and belongs to `content`.
  WindowWatch(QWidget& content, Duration patience);
  ~WindowWatch() override;

 signals:
  /// Repeated while the window cannot be seen.
  void cannotBeSeen();

 private:
  class Server;

  void look();

  QWidget& content_;
  const Duration patience_;
  std::unique_ptr<Server> server_;
  QTimer timer_;
};

}  // namespace frontier_pilot::gui
