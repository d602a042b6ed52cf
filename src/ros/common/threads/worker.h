#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "ros/common/messages/mailbox.h"

namespace frontier_pilot {

/// Runs one long job at a time on a thread of its own; the owner polls for the result. The job's captured data is
/// destroyed on that thread, too. If a job throws, there is a failure instead of a result. The destructor waits for the
/// job that is running.
template <class Result>
class Worker {
 public:
  using Job = std::function<Result()>;

  Worker() : thread_(&Worker::run, this) {}
  ~Worker() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ending_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Whether no job is running and the result or failure of the last one has been taken.
  bool idle() const { return idle_; }
  /// Starts a job; only to be called when idle() is true.
  void start(Job job) {
    idle_ = false;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      job_ = std::move(job);
    }
    wake_.notify_all();
  }
  /// Starts a job as soon as the present one has ended and its end has been taken; at once if there is none. A job that
  /// is still waiting then is replaced.
  void startNext(Job job) {
    if (idle_) return start(std::move(job));
    next_ = std::move(job);
  }
  /// The result, once.
  std::optional<Result> take() {
    std::optional<Result> result = result_.take();
    if (result) ended();
    return result;
  }
  /// The text of the exception that the job threw, once.
  std::optional<std::string> takeFailure() {
    std::optional<std::string> failure = failure_.take();
    if (failure) ended();
    return failure;
  }

 private:
  void ended() {
    idle_ = true;
    if (next_) start(std::exchange(next_, nullptr));
  }

  void run() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
      wake_.wait(lock, [this] { return ending_ || job_; });
      if (ending_) return;
      Job job = std::exchange(job_, nullptr);
      lock.unlock();
      perform(std::move(job));
      lock.lock();
    }
  }

  /// Takes `job` by value, so that it is destroyed on this thread.
  void perform(Job job) {
    try {
      result_.put(job());
    } catch (const std::exception& error) {
      failure_.put(error.what());
    } catch (...) {
      failure_.put("an exception of unknown type");
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  Job job_;
  bool ending_ = false;
  bool idle_ = true;  ///< used by the owner's thread alone, as is the next one
  Job next_;
  Mailbox<Result> result_;
  Mailbox<std::string> failure_;
  std::thread thread_;  ///< the last member: it starts when all others are constructed
};

}  // namespace frontier_pilot
