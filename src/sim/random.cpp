#include "sim/random.h"

#include <cmath>

namespace frontier_pilot::sim {
namespace {

std::uint64_t rotateLeft(std::uint64_t x, int by) { return (x << by) | (x >> (64 - by)); }

// SplitMix64, which the authors of xoshiro recommend for seeding.
std::uint64_t splitMix(std::uint64_t& x) {
  std::uint64_t z = (x += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

}  // namespace

Random::Random(std::uint64_t seed, std::uint64_t stream) : state_() {
  std::uint64_t mixed = stream;
  std::uint64_t x = seed ^ splitMix(mixed);
  for (std::uint64_t& word : state_) word = splitMix(x);
}

std::uint64_t Random::bits() {
  const std::uint64_t result = rotateLeft(state_[0] + state_[3], 23) + state_[0];
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = rotateLeft(state_[3], 45);
  return result;
}

double Random::gaussian() {
  has_spare_ = !has_spare_;
  if (!has_spare_) return spare_;
  double u = 0.0;
  double v = 0.0;
  double s = 0.0;
  do {
    u = 2.0 * uniform() - 1.0;
    v = 2.0 * uniform() - 1.0;
    s = u * u + v * v;
  } while (s >= 1.0 || s == 0.0);
  const double scale = std::sqrt(-2.0 * std::log(s) / s);
  spare_ = v * scale;
  return u * scale;
}

}  // namespace frontier_pilot::sim
