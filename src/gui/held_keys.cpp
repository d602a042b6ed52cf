#include "gui/held_keys.h"

#include <QKeyEvent>
#include <QTimer>

namespace frontier_pilot::gui {
namespace {

constexpr int kPatience = 40;         // for the press of a repetition to be read [ms]
constexpr unsigned long kAtOnce = 5;  // a finger does not press again so soon [ms]

}  // namespace

void HeldKeys::press(const QKeyEvent& event) {
  if (event.isAutoRepeat()) return;
  const auto release = releases_.find(event.key());
  if (release != releases_.end()) {
    const bool is_repetition = event.timestamp() - release->second <= kAtOnce;
    releases_.erase(release);
    if (is_repetition) return;
    emit released(event.key());
  }
  emit pressed(event.key());
}

void HeldKeys::release(const QKeyEvent& event) {
  if (event.isAutoRepeat()) return;
  if (event.timestamp() == 0) return emit released(event.key());
  releases_[event.key()] = event.timestamp();
  QTimer::singleShot(kPatience, this, [this, key = event.key(), stamp = event.timestamp()] { endRelease(key, stamp); });
}

void HeldKeys::endRelease(int key, unsigned long stamp) {
  const auto release = releases_.find(key);
  if (release == releases_.end() || release->second != stamp) return;
  releases_.erase(release);
  emit released(key);
}

}  // namespace frontier_pilot::gui
