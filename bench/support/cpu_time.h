#pragma once

#include <ctime>

namespace frontier_pilot::bench {

/// The CPU time of this thread [s], which other load of the machine does not affect directly.
inline double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace frontier_pilot::bench
