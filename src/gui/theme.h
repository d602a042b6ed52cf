#pragma once

#include <QColor>
#include <QPalette>
#include <QString>
#include <QWidget>

#include "teleop/operator_state.h"

namespace frontier_pilot::gui {

/// The colours of the cards, derived from the desktop's palette so that light and dark palettes both work.
struct Theme {
  bool dark = false;
  QColor window, card, field, border, text, muted, accent, on_accent, good, warning, danger, idle;

  static Theme of(const QPalette& palette);
  /// The theme for the application's palette.
  static Theme current();
  QColor color(teleop::Severity severity) const;
  /// The style sheet of the widget; lengths follow `em`, the height of a line [px].
  QString styleSheet(int em) const;
};

/// Sets the style sheet of `widget` by the current theme. That causes another event of a changed style, after which
/// nothing is to be done any more.
void applyTheme(QWidget& widget);

/// The project's own light or dark palette, for use instead of the desktop's.
QPalette pilotPalette(bool dark);

/// The height of a line in the widget's font [px]: the unit of all lengths, so that they follow font size and scaling.
int emOf(const QWidget& widget);

/// `color` with the given opacity (0 to 1).
QColor faded(QColor color, double opacity);

}  // namespace frontier_pilot::gui
