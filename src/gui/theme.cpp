#include "gui/theme.h"

#include <QFontMetrics>
#include <QGuiApplication>

namespace frontier_pilot::gui {
namespace {

QColor mixed(const QColor& a, const QColor& b, double share_of_b) {
  const auto mix = [share_of_b](qreal from, qreal to) { return from + (to - from) * share_of_b; };
  return QColor::fromRgbF(mix(a.redF(), b.redF()), mix(a.greenF(), b.greenF()), mix(a.blueF(), b.blueF()));
}

// Placeholders: %1 window, %2 card, %3 field, %4 border, %5 text, %6 muted, %7 accent, %8 text on accent, %9 danger.
const char* const kRules = R"(
#fleet_window, #pilot, #pilotBody, #pilotScroll { background: %1; border: none; }
#fleetBody, #fleetScroll { background: %2; border: none; }
QFrame#card { background: %2; border: 1px solid %4; border-radius: $R; }
QLabel { color: %5; background: transparent; }
QLabel[role="title"] { color: %6; font-weight: 600; }
QLabel[role="muted"] { color: %6; }
QLabel[role="strong"] { font-weight: 600; }
QLabel[role="headline"] { font-weight: 700; font-size: $Hpx; }
QLabel[role="figure"] { font-weight: 600; font-size: $Fpx; }
QPushButton { background: %3; color: %5; border: 1px solid %4; border-radius: $r; padding: $p $P; }
QPushButton:hover { border-color: %7; }
QPushButton:pressed, QPushButton:checked { background: %7; color: %8; border-color: %7; }
QPushButton:focus { border-color: %7; }
QPushButton:disabled { color: %6; background: transparent; border-style: dashed; }
QPushButton[role="primary"] { background: %7; color: %8; border-color: %7; font-weight: 600; }
QPushButton[role="primary"]:disabled { background: transparent; color: %6; border-color: %4; font-weight: 400; }
QPushButton[role="small"] { padding: 0 $P; }
QPushButton[role="stop"] { color: %9; border-color: %9; font-weight: 700; }
QPushButton[role="stop"]:pressed { background: %9; color: white; }
QCheckBox { color: %5; }
QCheckBox::indicator { width: $i; height: $i; background: %3; border: 1px solid %6; border-radius: $q; }
QCheckBox::indicator:checked { background: %7; border-color: %7; }
QPlainTextEdit { background: %3; color: %5; border: 1px solid %4; border-radius: $r; }
)";

}  // namespace

Theme Theme::of(const QPalette& palette) {
  Theme theme;
  theme.window = palette.color(QPalette::Window);
  theme.text = palette.color(QPalette::WindowText);
  theme.dark = theme.window.lightnessF() < 0.5;
  const bool dark = theme.dark;
  theme.card = dark ? mixed(theme.window, Qt::white, 0.045) : mixed(theme.window, Qt::white, 0.8);
  theme.field = dark ? mixed(theme.window, Qt::white, 0.09) : mixed(theme.window, Qt::white, 0.45);
  theme.border = mixed(theme.window, theme.text, dark ? 0.18 : 0.16);
  theme.muted = mixed(theme.text, theme.card, dark ? 0.36 : 0.38);
  theme.accent = dark ? QColor("#6aa5ff") : QColor("#1f5fd6");
  theme.on_accent = dark ? QColor("#0b1220") : QColor("#ffffff");
  theme.good = dark ? QColor("#43cf83") : QColor("#12874a");
  theme.warning = dark ? QColor("#f2b04a") : QColor("#b45d04");
  theme.danger = dark ? QColor("#ff5a5f") : QColor("#d11f2a");
  theme.idle = mixed(theme.text, theme.card, 0.6);
  return theme;
}

Theme Theme::current() { return of(QGuiApplication::palette()); }

QColor Theme::color(teleop::Severity severity) const {
  switch (severity) {
    case teleop::Severity::kIdle:
      return idle;
    case teleop::Severity::kGood:
      return good;
    case teleop::Severity::kActive:
      return accent;
    case teleop::Severity::kWarning:
      return warning;
    case teleop::Severity::kError:
      break;
  }
  return danger;
}

QString Theme::styleSheet(int em) const {
  QString rules = QString(kRules).arg(window.name(), card.name(), field.name(), border.name(), text.name(),
                                      muted.name(), accent.name(), on_accent.name(), danger.name());
  const auto length = [em](double share) { return QString::number(qMax(1, qRound(em * share))) + "px"; };
  rules.replace("$Hpx", length(1.25)).replace("$Fpx", length(1.2)).replace("$R", length(0.5));
  return rules.replace("$r", length(0.35))
      .replace("$p", length(0.3))
      .replace("$P", length(0.4))
      .replace("$q", length(0.2))
      .replace("$i", length(0.75));
}

void applyTheme(QWidget& widget) {
  const QString sheet = Theme::current().styleSheet(emOf(widget));
  if (widget.styleSheet() != sheet) widget.setStyleSheet(sheet);
}

QPalette pilotPalette(bool dark) {
  const QColor window = dark ? QColor("#161a21") : QColor("#eceff3");
  const QColor text = dark ? QColor("#e7ebf2") : QColor("#18202b");
  QPalette palette(dark ? QColor("#262c37") : QColor("#e4e8ee"), window);
  palette.setColor(QPalette::Base, dark ? QColor("#1d222b") : QColor("#ffffff"));
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(role, text);
    palette.setColor(QPalette::Disabled, role, mixed(text, window, 0.5));
  }
  palette.setColor(QPalette::Highlight, Theme::of(palette).accent);
  palette.setColor(QPalette::HighlightedText, Theme::of(palette).on_accent);
  return palette;
}

int emOf(const QWidget& widget) { return QFontMetrics(widget.font()).height(); }

QColor faded(QColor color, double opacity) {
  color.setAlphaF(opacity);
  return color;
}

}  // namespace frontier_pilot::gui
