#include "gui/pilot_window.h"

#include <QApplication>
#include <QScreen>
#include <QStyleFactory>
#include <cstdlib>
#include <functional>
#include <string>

#include "gui/fleet_window.h"
#include "gui/theme.h"

namespace frontier_pilot::gui {
namespace {

/// Wide enough for four columns. On a screen that is too narrow for these the columns are fewer and longer, and the
/// window is as high as the screen.
QSize windowSize(const QWidget& widget) {
  const int em = emOf(widget);
  const QSize wanted(em * 86, em * 46);
  const QScreen* screen = QGuiApplication::primaryScreen();
  if (screen == nullptr) return wanted;
  const QSize room = screen->availableSize() * 0.95;
  return room.width() < wanted.width() ? room : wanted.boundedTo(room);
}

std::function<void(const std::string&)> g_say_why_not;

/// Qt aborts where there is no display, after some lines of its own. The first of these is the reason.
void endWithoutWindow(QtMsgType type, const QMessageLogContext& /*context*/, const QString& text) {
  static const QString reason = text.section('\n', 0, 0);
  if (type != QtFatalMsg) return;
  g_say_why_not(reason.toStdString());
  std::_Exit(EXIT_FAILURE);
}

bool g_is_running = false;

/// Qt calls exit() from within its event loop when the connection to the display is lost, which would destroy static
/// objects that other threads, such as those of ROS, still use. The arbiter takes a window that is gone for silent.
void endAtOnce() {
  if (g_is_running) std::_Exit(EXIT_FAILURE);
}

/// Runs the event loop. The handler is registered after all static objects were made, so that it runs before any of
/// them is destroyed.
int runUntilClosed() {
  std::atexit(endAtOnce);
  g_is_running = true;
  const int exit_code = QApplication::exec();
  g_is_running = false;
  return exit_code;
}

}  // namespace

int runPilotWindow(int argc, char** argv, teleop::FleetLink& link, const std::string& palette,
                   const std::function<void(const std::string&)>& say_why_not, const std::function<void()>& closed) {
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  g_say_why_not = say_why_not;
  qInstallMessageHandler(endWithoutWindow);
  QApplication application(argc, argv);
  qInstallMessageHandler(nullptr);
  QApplication::setApplicationName("frontier_pilot");
  if (palette != "system") {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QApplication::setPalette(pilotPalette(palette == "dark"));
  }
  FleetWindow window(link);
  QObject::connect(&window, &FleetWindow::closeAsked, &application, &QApplication::quit);
  // The zero is sent when the window closes, before destructors run.
  QObject::connect(&application, &QApplication::aboutToQuit, &window, &FleetWindow::release);
  window.resize(windowSize(window));
  window.show();
  const int exit_code = runUntilClosed();
  closed();
  return exit_code;
}

}  // namespace frontier_pilot::gui
