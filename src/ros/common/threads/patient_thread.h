#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "frontier_pilot/core/time.h"

namespace frontier_pilot {

/// A thread for jobs that may hang, such as those on a disk, which is waited for only so long. A job that takes longer
/// goes on, and as long as it does no other one is begun and nobody waits. Safe to use from several threads.
class PatientThread {
 public:
  explicit PatientThread(Duration patience);
  /// Does not wait for a job that hangs: that keeps what it uses.
  ~PatientThread();
  PatientThread(const PatientThread&) = delete;
  PatientThread& operator=(const PatientThread&) = delete;

  /// What `job` returns; nothing if it has not ended in time, has thrown, or was not begun because another one hangs.
  /// The job must own all that it uses.
  template <class Result>
  std::optional<Result> run(std::function<Result()> job) {
    const auto result = std::make_shared<std::optional<Result>>();
    const bool ended = runJob([job = std::move(job), result] { *result = job(); });
    return ended ? *result : std::nullopt;
  }

 private:
  struct State {
    std::mutex mutex;
    std::condition_variable wake;
    std::function<void()> job;  ///< that is to be run, or runs
    std::uint64_t begun = 0;    ///< jobs, the one that runs included
    std::uint64_t ended = 0;    ///< jobs
    bool late = false;          ///< the one that runs was waited for in vain
    bool ending = false;
  };

  bool runJob(std::function<void()> job);
  static void loop(const std::shared_ptr<State>& state);

  const Duration patience_;
  const std::shared_ptr<State> state_ = std::make_shared<State>();
};

}  // namespace frontier_pilot
