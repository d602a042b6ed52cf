#pragma once

namespace frontier_pilot::system {

/// Adds the time that a scope took [s], by a clock that may be missing.
class Stopwatch {
 public:
  Stopwatch(double (*clock)(), double& total)
      : clock_(clock), total_(total), start_(clock != nullptr ? clock() : 0.0) {}
  ~Stopwatch() {
    if (clock_ != nullptr) total_ += clock_() - start_;
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double (*clock_)();
  double& total_;
  double start_;
};

}  // namespace frontier_pilot::system
