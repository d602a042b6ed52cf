#include "gui/pilot_window.h"

#include <QApplication>
#include <QScreen>
#include <QStyleFactory>

#include "gui/pilot_controller.h"
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

int runPilotWindow(int argc, char** argv, teleop::OperatorLink& link, const teleop::TeleopParameters& parameters) {
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QApplication application(argc, argv);
  QApplication::setApplicationName("frontier_pilot");
  if (parameters.palette != "system") {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QApplication::setPalette(pilotPalette(parameters.palette == "dark"));
  }
  PilotWidget widget(parameters);
  PilotController controller(widget, link, fromSeconds(parameters.liveness_timeout));
  QObject::connect(&controller, &PilotController::closeAsked, &application, &QApplication::quit);
  // The zero is sent when the window closes, before destructors run.
  QObject::connect(&application, &QApplication::aboutToQuit, &controller, &PilotController::close);
  widget.resize(windowSize(widget));
  widget.show();
  widget.setFocus();
  return QApplication::exec();
}

}  // namespace frontier_pilot::gui
