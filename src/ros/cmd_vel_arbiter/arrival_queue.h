#pragma once

#include <ros/callback_queue.h>
#include <ros/callback_queue_interface.h>

#include <algorithm>
#include <boost/enable_shared_from_this.hpp>
#include <boost/make_shared.hpp>
#include <functional>
#include <mutex>
#include <utility>
#include <vector>

#include "ros/common/clock.h"

namespace frontier_pilot {

/// Passes callbacks on to the node's own queue and records when each of them arrived, so that the handler of a call
/// knows whether something happened while the call was waiting. While this queue is held, callbacks wait in it. roscpp
/// adds them from threads of its own.
class ArrivalQueue : public ros::CallbackQueueInterface {
 public:
  /// `before()` runs before each callback, and may hold the queue.
  explicit ArrivalQueue(std::function<void()> before = [] {}) : before_(std::move(before)) {}

  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) override {
    ros::getGlobalCallbackQueue()->addCallback(boost::make_shared<Stamped>(*this, callback, owner), owner);
  }
  void removeByID(std::uint64_t owner) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.erase(
        std::remove_if(waiting_.begin(), waiting_.end(), [=](const auto& one) { return one.second == owner; }),
        waiting_.end());
    ros::getGlobalCallbackQueue()->removeByID(owner);
  }

  /// From now on callbacks wait.
  void hold() {
    const std::lock_guard<std::mutex> lock(mutex_);
    held_ = true;
  }
  /// Passes the waiting callbacks on, and later ones at once.
  void release() {
    const std::lock_guard<std::mutex> lock(mutex_);
    held_ = false;
    for (const auto& [callback, owner] : waiting_) ros::getGlobalCallbackQueue()->addCallback(callback, owner);
    waiting_.clear();
  }

  /// When the callback that is running now had arrived.
  SteadyTime arrival() const { return arrival_; }

 private:
  class Stamped : public ros::CallbackInterface, public boost::enable_shared_from_this<Stamped> {
   public:
    Stamped(ArrivalQueue& queue, ros::CallbackInterfacePtr callback, std::uint64_t owner)
        : queue_(queue), callback_(std::move(callback)), owner_(owner), arrived_(steadyNow()) {}
    CallResult call() override {
      if (queue_.keeps(shared_from_this(), owner_)) return Success;
      queue_.arrival_ = arrived_;
      return callback_->call();
    }
    bool ready() override { return callback_->ready(); }

   private:
    ArrivalQueue& queue_;
    ros::CallbackInterfacePtr callback_;
    std::uint64_t owner_;
    SteadyTime arrived_;
  };

  /// Whether the callback has to wait, and is kept here meanwhile.
  bool keeps(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) {
    before_();
    const std::lock_guard<std::mutex> lock(mutex_);
    if (held_) waiting_.emplace_back(callback, owner);
    return held_;
  }

  std::function<void()> before_;
  std::mutex mutex_;
  bool held_ = false;
  std::vector<std::pair<ros::CallbackInterfacePtr, std::uint64_t>> waiting_;
  SteadyTime arrival_{};  ///< used only by the thread that runs the callbacks
};

}  // namespace frontier_pilot
