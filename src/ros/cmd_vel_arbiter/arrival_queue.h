#pragma once

#include <ros/callback_queue.h>
#include <ros/callback_queue_interface.h>

#include <algorithm>
#include <boost/make_shared.hpp>
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
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    const ros::CallbackInterfacePtr stamped = boost::make_shared<Stamped>(callback, arrival_);
    if (held_) {
      waiting_.emplace_back(stamped, owner);
    } else {
      ros::getGlobalCallbackQueue()->addCallback(stamped, owner);
    }
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
  class Stamped : public ros::CallbackInterface {
   public:
    Stamped(ros::CallbackInterfacePtr callback, SteadyTime& current)
        : callback_(std::move(callback)), arrived_(steadyNow()), current_(current) {}
    CallResult call() override {
      current_ = arrived_;
      return callback_->call();
    }
    bool ready() override { return callback_->ready(); }

   private:
    ros::CallbackInterfacePtr callback_;
    SteadyTime arrived_;
    SteadyTime& current_;
  };

  std::mutex mutex_;
  bool held_ = false;
  std::vector<std::pair<ros::CallbackInterfacePtr, std::uint64_t>> waiting_;
  SteadyTime arrival_{};  ///< used only by the thread that runs the callbacks
};

}  // namespace frontier_pilot
