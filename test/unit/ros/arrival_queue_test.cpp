// The queue through which the calls of an arbiter's services go.

#include "ros/cmd_vel_arbiter/arrival_queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <future>
#include <thread>

namespace frontier_pilot {
namespace {

constexpr std::uint64_t kOwner = 7;

/// A callback that does nothing.
struct Nothing : ros::CallbackInterface {
  CallResult call() override { return Success; }
};

/// roscpp removes the callbacks of a service that ends on a thread of its own, and waits for the one that is running.
/// That one takes the queue's lock: if the removal held it, both would wait for ever, and no zero would be sent any
/// more. [ARB-12]
TEST(ArrivalQueue, IsNotLockedWhileARemovalWaitsForTheCallbackThatRuns_ARB_12) {
  std::atomic<bool> begun{false}, removing{false};
  const auto before = [&] {
    begun = true;
    while (!removing) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // until the removal waits
  };
  ros::CallbackQueue nodes;
  ArrivalQueue queue(before, &nodes);
  queue.addCallback(boost::make_shared<Nothing>(), kOwner);
  auto calling = std::async(std::launch::async, [&] { nodes.callAvailable(); });
  auto removal = std::async(std::launch::async, [&] {
    while (!begun) std::this_thread::yield();
    removing = true;
    queue.removeByID(kOwner);
  });
  for (auto* one : {&calling, &removal}) {
    if (one->wait_for(std::chrono::seconds(20)) == std::future_status::ready) continue;
    ADD_FAILURE() << "they wait for each other";
    std::_Exit(EXIT_FAILURE);  // the destructor of a future would wait as well
  }
}

}  // namespace
}  // namespace frontier_pilot
