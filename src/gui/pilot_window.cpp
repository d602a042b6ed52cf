#include "gui/pilot_window.h"

#include <QApplication>
#include <QScreen>
#include <QStyleFactory>

#include "gui/fleet_window.h"
#include "gui/theme.h"

namespace frontier_pilot::gui {
namespace {

/// Wide enough for four columns, if the screen is wide enough.
QSize windowSize(const QWidget& widget) {
  const int em = emOf(widget);
  const QSize wanted(em * 86, em * 46);
  const QScreen* screen = QGuiApplication::primaryScreen();
  return screen == nullptr ? wanted : wanted.boundedTo(screen->availableSize() * 0.95);
}

}  // namespace

int runPilotWindow(int argc, char** argv, teleop::FleetLink& link, const std::string& palette) {
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QApplication application(argc, argv);
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
  return QApplication::exec();
}

}  // namespace frontier_pilot::gui
