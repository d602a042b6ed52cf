#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>

namespace frontier_pilot::gui {

/// Says while the window of a widget cannot be seen, as far as the X server knows: a window manager may unmap its
/// frame, because the window is on another workspace or behind a tab, without a word that Qt passes on. A window that
/// another one covers is not reported, nor is anything where Qt draws without an X server. Never waits for the server.
class WindowWatch : public QObject {
  Q_OBJECT

 public:
  /// Watches the window that `content` is in, and belongs to `content`.
  explicit WindowWatch(QWidget& content);
  ~WindowWatch() override;

 signals:
  /// Repeated while the window cannot be seen.
  void cannotBeSeen();

 private:
  class Server;

  void look();

  QWidget& content_;
  std::unique_ptr<Server> server_;
  QTimer timer_;
};

}  // namespace frontier_pilot::gui
