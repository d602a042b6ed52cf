#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

#include "support/cpu_time.h"

namespace frontier_pilot::bench {

/// Measures the CPU time of calls, one by one.
class Stopwatch {
 public:
  template <class Work>
  void time(Work&& work) {
    const double start = threadSeconds();
    work();
    micros_.push_back(1e6 * (threadSeconds() - start));
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
