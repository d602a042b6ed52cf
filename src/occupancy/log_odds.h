#pragma once

#include <cmath>

namespace frontier_pilot::occupancy {

/// A probability as log-odds, with OctoMap's precision.
inline float logOdds(double probability) { return static_cast<float>(std::log(probability / (1.0 - probability))); }

/// Log-odds as a probability.
inline double probability(float log_odds) { return 1.0 - 1.0 / (1.0 + std::exp(static_cast<double>(log_odds))); }

}  // namespace frontier_pilot::occupancy
