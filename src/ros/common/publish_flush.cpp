#include "ros/common/publish_flush.h"

#include <ros/init.h>
#include <ros/poll_manager.h>

#include "ros/common/clock.h"

namespace frontier_pilot {
namespace {

/// Each round of the poll thread calls its listeners (roscpp's own first, which hands published messages to the
/// connections, then this one) and then writes to the sockets. The first round counted may have begun before the
/// message was published. The second certainly hands it to the connections, and when the third is counted it has been
/// written.
constexpr std::uint64_t kRounds = 3;

}  // namespace

PublishFlush::PublishFlush() {
  listener_ = ros::PollManager::instance()->addPollThreadListener([this] { countRound(); });
}

PublishFlush::~PublishFlush() { ros::PollManager::instance()->removePollThreadListener(listener_); }

void PublishFlush::countRound() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++rounds_;
  }
  round_done_.notify_all();
}

bool PublishFlush::wait(Duration patience) {
  const SteadyTime deadline = steadyNow() + patience;
  std::unique_lock<std::mutex> lock(mutex_);
  const std::uint64_t done = rounds_ + kRounds;
  while (rounds_ < done) {
    const std::uint64_t before = rounds_;
    lock.unlock();
    ros::PollManager::instance()->getPollSet().signal();  // an idle poll thread sleeps for up to 100 ms
    lock.lock();
    const Duration left = deadline - steadyNow();
    if (left <= Duration::zero()) return false;
    round_done_.wait_for(lock, left, [&] { return rounds_ > before; });
  }
  return true;
}

void flushLastWords() {
  constexpr Duration kPatience = std::chrono::milliseconds(500);
  if (ros::ok()) PublishFlush().wait(kPatience);
}

}  // namespace frontier_pilot
