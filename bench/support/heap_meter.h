#pragma once

#include <cstddef>

namespace frontier_pilot::bench {

/// What the program has allocated with `new` and not freed: now, and at most since the last `restart`. Programs that
/// link it count every allocation, which costs a few nanoseconds each.
class HeapMeter {
 public:
  static std::size_t inUse();  ///< [bytes]
  static std::size_t peak();   ///< [bytes]
  static void restart();
};

}  // namespace frontier_pilot::bench
