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
    stopTimer(release->second);
    if (event.timestamp() - release->second.stamp <= kAtOnce) return;
  }
  letGo(event.key());  // its release was not seen, or not counted yet
  held_[event.key()] = event.nativeScanCode();
  emit pressed(event.key());
}

void HeldKeys::release(const QKeyEvent& event) {
  if (event.isAutoRepeat()) return;
  const int key = heldKeyOf(event);
  if (event.timestamp() == 0) return letGo(key);
  if (held_.count(key) == 0 && releases_.count(key) == 0) return;  // never pressed here
  Release& release = releases_[key];
  stopTimer(release);
  release = {event.timestamp(), startTimer(kPatience)};
}

int HeldKeys::heldKeyOf(const QKeyEvent& event) const {
  for (const auto& [key, scan_code] : held_) {
    if (scan_code != 0 && scan_code == event.nativeScanCode()) return key;
  }
  return event.key();
}

void HeldKeys::letGo(int key) {
  if (held_.erase(key) > 0) emit released(key);
}

void HeldKeys::stopTimer(Release& release) {
  if (release.timer != 0) killTimer(std::exchange(release.timer, 0));
}

void HeldKeys::timerEvent(QTimerEvent* event) {
  for (auto& [key, release] : releases_) {
    if (release.timer != event->timerId()) continue;
    stopTimer(release);
    return letGo(key);
  }
}

}  // namespace frontier_pilot::gui
