#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "ros/common/master/ros_sessions.h"

namespace frontier_pilot {

/// Tells the names of the ROS session to those who keep something in it. A master that hangs just then tells no name,
/// and is asked again. [FLT-2]
class SessionNews {
 public:
  using Sessions = std::vector<std::string>;
  using Listener = std::function<void(const Sessions&)>;

  /// `ask` gives the names; none if the master does not tell them.
  explicit SessionNews(std::function<Sessions()> ask = rosSessions) : ask_(std::move(ask)) {}

  /// `f` is told with the next `tell`, and after each `renew`. It is called on the thread that tells.
  void add(Listener f) {
    const std::lock_guard<std::mutex> lock(mutex_);
    listeners_.push_back(std::move(f));
    due_ = true;
  }
  /// The session may be another one now.
  void renew() { due_ = true; }
  /// Asks, if there is anything to tell; without an answer, again with the next call.
  void tell() {
    if (!due_.exchange(false)) return;
    const Sessions sessions = ask_();
    if (sessions.empty()) return renew();
    std::unique_lock<std::mutex> lock(mutex_);
    const std::vector<Listener> listeners = listeners_;
    lock.unlock();
    for (const Listener& listener : listeners) listener(sessions);
  }

 private:
  std::function<Sessions()> ask_;
  std::atomic<bool> due_{false};
  std::mutex mutex_;  ///< guards the listeners
  std::vector<Listener> listeners_;
};

}  // namespace frontier_pilot
