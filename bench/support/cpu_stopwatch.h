#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <vector>

namespace frontier_pilot::bench {

/// The CPU time of this thread [us], which other load of the machine does not affect directly.
inline double cpuMicros() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

/// Measures the CPU time of calls, one by one.
class Stopwatch {
 public:
  template <class Work>
  void time(Work&& work) {
    const double start = cpuMicros();
    work();
    micros_.push_back(cpuMicros() - start);
  }
  void report(benchmark::State& state) {
    std::sort(micros_.begin(), micros_.end());
    double sum = 0.0;
    for (const double t : micros_) sum += t;
    state.counters["scans"] = static_cast<double>(micros_.size());
    state.counters["mean_us"] = sum / static_cast<double>(micros_.size());
    state.counters["p50_us"] = micros_[micros_.size() / 2];
    state.counters["p99_us"] = micros_[micros_.size() * 99 / 100];
    state.counters["max_us"] = micros_.back();
  }

 private:
  std::vector<double> micros_;
};

}  // namespace frontier_pilot::bench
