#pragma once

#include <algorithm>
#include <cstdint>
#include <random>

namespace frontier_pilot::bench {

/// Random draws that are the same with every standard library, which its own distributions are not.
class PlanRandom {
 public:
  explicit PlanRandom(std::uint64_t seed) : engine_(seed) {}

  /// An integer of [low, high], which must not be empty. The bias of the remainder is less than 1e-12 here.
  int between(int low, int high) {
    const auto count = static_cast<std::uint64_t>(std::max(high - low + 1, 1));
    return low + static_cast<int>(engine_() % count);
  }
  /// True in `percent` of all cases.
  bool chance(int percent) { return between(1, 100) <= percent; }
  /// One of the elements of `choices`, which must not be empty.
  template <class Choices>
  auto oneOf(const Choices& choices) {
    return *(choices.begin() + between(0, static_cast<int>(choices.size()) - 1));
  }
  template <class T>
  T oneOf(std::initializer_list<T> choices) {
    return *(choices.begin() + between(0, static_cast<int>(choices.size()) - 1));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace frontier_pilot::bench
