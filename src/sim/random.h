#pragma once

#include <array>
#include <cstdint>

namespace frontier_pilot::sim {

/// A seeded source of noise that gives the same numbers with every standard library (std::normal_distribution does
/// not). xoshiro256++ of Blackman & Vigna, "Scrambled Linear Pseudorandom Number Generators", TOMS 47(4), 2021.
class Random {
 public:
  /// Streams of one seed are independent of each other: one per robot and purpose.
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0);

  std::uint64_t bits();
  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  /// Normal with mean 0 and standard deviation 1, by Marsaglia's polar method.
  double gaussian();

 private:
  std::array<std::uint64_t, 4> state_;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

}  // namespace frontier_pilot::sim
