#include "gui/held_keys.h"

#include <QKeyEvent>
#include <QTimerEvent>
#include <utility>

namespace frontier_pilot::gui {
namespace {

constexpr int kPatience = 40;         // for the press of a repetition to be read [ms]
constexpr unsigned long kAtOnce = 5;  // a finger does not press again so soon [ms]

}  // namespace

/// A press with the stamp of the last release is a repetition also if that release has counted, because the window was
/// busy: the robot then stands until a new press.
void HeldKeys::press(const QKeyEvent& event) {
  if (event.isAutoRepeat()) return;
  const auto release = releases_.find(event.key());
  if (release != releases_.end()) {
    const bool is_repetition = event.timestamp() - release->second.stamp <= kAtOnce;
    const bool waited = takeTimer(release->second);
    if (is_repetition) return;
    if (waited) emit released(event.key());
  }
  emit pressed(event.key());
}

void HeldKeys::release(const QKeyEvent& event) {
  if (event.isAutoRepeat()) return;
  if (event.timestamp() == 0) return emit released(event.key());
  Release& release = releases_[event.key()];
  takeTimer(release);
  release = {event.timestamp(), startTimer(kPatience)};
}

bool HeldKeys::takeTimer(Release& release) {
  if (release.timer == 0) return false;
  killTimer(std::exchange(release.timer, 0));
  return true;
}

void HeldKeys::timerEvent(QTimerEvent* event) {
  for (auto& [key, release] : releases_) {
    if (release.timer != event->timerId()) continue;
    takeTimer(release);
    return emit released(key);
  }
}

}  // namespace frontier_pilot::gui
