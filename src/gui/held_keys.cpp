#include "gui/held_keys.h"

#include <QKeyEvent>
#include <QTimer>
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
    const bool waits = std::exchange(release->second.waits, false);
    if (is_repetition) return;
    if (waits) emit released(event.key());
  }
  emit pressed(event.key());
}

void HeldKeys::release(const QKeyEvent& event) {
  if (event.isAutoRepeat()) return;
  if (event.timestamp() == 0) return emit released(event.key());
  releases_[event.key()] = {event.timestamp(), true};
  QTimer::singleShot(kPatience, this, [this, key = event.key(), stamp = event.timestamp()] { endRelease(key, stamp); });
}

void HeldKeys::endRelease(int key, unsigned long stamp) {
  Release& release = releases_[key];
  if (release.stamp != stamp || !std::exchange(release.waits, false)) return;
  emit released(key);
}

}  // namespace frontier_pilot::gui
