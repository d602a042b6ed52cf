#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QKeyEvent>

#include "gui/held_keys.h"
#include "gui/pilot_widget.h"

namespace frontier_pilot::gui {
namespace {

std::optional<teleop::DriveKey> driveKeyOf(int key) {
  switch (key) {
    case Qt::Key_Up:
      return teleop::DriveKey::kUp;
    case Qt::Key_Down:
      return teleop::DriveKey::kDown;
    case Qt::Key_Left:
      return teleop::DriveKey::kLeft;
    case Qt::Key_Right:
      return teleop::DriveKey::kRight;
    case Qt::Key_W:
      return teleop::DriveKey::kW;
    case Qt::Key_A:
      return teleop::DriveKey::kA;
    case Qt::Key_S:
      return teleop::DriveKey::kS;
    case Qt::Key_D:
      return teleop::DriveKey::kD;
    case Qt::Key_Space:
      return teleop::DriveKey::kSpace;
    default:
      return std::nullopt;
  }
}

bool isKeyEvent(QEvent::Type type) {
  return type == QEvent::KeyPress || type == QEvent::KeyRelease || type == QEvent::ShortcutOverride;
}

/// Whether the arrows and letters are the widget's, which edits a number.
bool edits(const QWidget* widget) { return qobject_cast<const QAbstractSpinBox*>(widget) != nullptr; }

bool hasCommandModifier(const QKeyEvent& event) {
  return (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != 0;
}

}  // namespace

void PilotWidget::connectKeys() {
  keys_ = new HeldKeys(this);
  connect(keys_, &HeldKeys::pressed, this, [this](int key) { press(teleop::motionOf(*driveKeyOf(key))); });
  connect(keys_, &HeldKeys::released, this, [this](int key) { release(teleop::motionOf(*driveKeyOf(key))); });
  // Keys drive wherever in the widget the focus is, so they are filtered before the child with the focus gets them.
  qApp->installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget* before, QWidget* now) {
    // Qt moves the focus from a button that is disabled to the next one, which Enter would then press.
    const bool was_disabled = before != nullptr && isAncestorOf(before) && !before->isEnabled();
    if (was_disabled && now != nullptr && isAncestorOf(now)) return setFocus();
    if (now == nullptr || (now != this && !isAncestorOf(now)) || edits(now)) letGo();
  });
}

bool PilotWidget::eventFilter(QObject* watched, QEvent* event) {
  auto* widget = qobject_cast<QWidget*>(watched);
  if (event->type() == QEvent::Show && widget != nullptr && widget->windowType() == Qt::Popup) letGo();
  if (!isKeyEvent(event->type())) return QWidget::eventFilter(watched, event);
  // Whoever reads it: a key that was let go must not drive.
  if (event->type() == QEvent::KeyRelease) keys_->release(static_cast<QKeyEvent&>(*event));
  // In a dialog space is written, and stops the robot all the same. A list that completes a name has no parent.
  if (widget != nullptr && (isInDialog(widget) || isInDialog(QApplication::focusWidget()))) {
    const bool is_space = static_cast<QKeyEvent&>(*event).key() == Qt::Key_Space;
    if (is_space && event->type() == QEvent::KeyPress) stopBecause("space was pressed");
    return false;
  }
  if (widget == nullptr || (widget != this && !isAncestorOf(widget))) return false;
  return handleKey(*widget, static_cast<QKeyEvent&>(*event));
}

/// Whether `widget` is in a window that this one has opened, such as the dialog that asks for a map file.
bool PilotWidget::isInDialog(const QWidget* widget) const {
  const QObject* window = widget == nullptr ? nullptr : widget->window();
  if (window == this->window()) return false;
  while (window != nullptr && window != this) window = window->parent();
  return window == this;
}

/// Returns true if the key was meant for this widget, and must not be passed on.
bool PilotWidget::handleKey(QWidget& focus, QKeyEvent& event) {
  if (hasCommandModifier(event)) return false;
  // Space stops the robot wherever the focus is, so Enter presses the button that has the focus.
  const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
  if (auto* button = qobject_cast<QAbstractButton*>(&focus); button != nullptr && enter) {
    if (event.type() == QEvent::KeyPress && !event.isAutoRepeat()) button->click();
    return event.type() == QEvent::KeyPress;
  }
  const auto key = driveKeyOf(event.key());
  if (!key || (edits(&focus) && *key != teleop::DriveKey::kSpace)) return false;
  // So that the key does not trigger a shortcut of the host application, such as a tool of rviz.
  if (event.type() == QEvent::ShortcutOverride) event.accept();
  if (event.type() == QEvent::KeyPress) keys_->press(event);
  return true;
}

}  // namespace frontier_pilot::gui
