#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <thread>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// Calls functions again and again on a thread of its own, one after the other: those that may wait, for a disk for
/// instance, and so hold up nothing else. Safe to use from several threads.
class PeriodicThread {
 public:
  /// Waits for `period` before each round.
  explicit PeriodicThread(Duration period);
  /// Waits for the function that runs.
  ~PeriodicThread();
  PeriodicThread(const PeriodicThread&) = delete;
  PeriodicThread& operator=(const PeriodicThread&) = delete;

  /// `f` is called in each round from now on; what it throws is dropped. Gives its number.
  int add(std::function<void()> f);
  /// The function with that number is not called any more; waits for it if it runs.
  void remove(int number);

 private:
  void run();

  const Duration period_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::map<int, std::function<void()>> functions_;  ///< by number
  int added_ = 0;                                   ///< functions so far
  int running_ = 0;                                 ///< the number of the one that runs; 0 if none does
  bool ending_ = false;
  std::thread thread_;  ///< the last member: it starts when all others are constructed
};

}  // namespace frontier_pilot
