#include "ros/common/threads/periodic_thread.h"

#include <exception>
#include <utility>

namespace frontier_pilot {

PeriodicThread::PeriodicThread(Duration period) : period_(period), thread_(&PeriodicThread::run, this) {}

PeriodicThread::~PeriodicThread() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

int PeriodicThread::add(std::function<void()> f) {
  const std::lock_guard<std::mutex> lock(mutex_);
  functions_[++added_] = std::move(f);
  return added_;
}

void PeriodicThread::remove(int number) {
  std::unique_lock<std::mutex> lock(mutex_);
  functions_.erase(number);
  wake_.wait(lock, [&] { return running_ != number; });
}

void PeriodicThread::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!wake_.wait_for(lock, period_, [this] { return ending_; })) {
    for (auto next = functions_.begin(); !ending_ && next != functions_.end();
         next = functions_.upper_bound(std::exchange(running_, 0))) {
      running_ = next->first;
      const std::function<void()> f = next->second;
      lock.unlock();
      try {
        f();
      } catch (const std::exception&) {  // it is called again in the next round
      }
      lock.lock();
      wake_.notify_all();
    }
  }
}

}  // namespace frontier_pilot
