#pragma once

#include <ros/callback_queue.h>
#include <ros/callback_queue_interface.h>

#include <boost/make_shared.hpp>

#include "ros/common/clock.h"

namespace frontier_pilot {

/// Puts callbacks into the node's own queue and remembers when each of them arrived, so that the one that is being
/// served can tell what happened while it was waiting.
class ArrivalQueue : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) override {
    ros::getGlobalCallbackQueue()->addCallback(boost::make_shared<Stamped>(callback, arrival_), owner);
  }
  void removeByID(std::uint64_t owner) override { ros::getGlobalCallbackQueue()->removeByID(owner); }

  /// When the callback that is running now arrived.
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

  SteadyTime arrival_{};
};

}  // namespace frontier_pilot
