#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot::occupancy {

/// The inverse sensor model: what one scan says about a cell, and how sure the map may become (so that it can still
/// change its mind). Hornung et al., "OctoMap", Autonomous Robots 34, 2013, eq. 2-4.
struct OccupancyModel {
  double hit = 0.7;         ///< probability that a cell is occupied, given that a beam ended in it
  double miss = 0.4;        ///< probability that a cell is occupied, given that a beam passed it
  double clamp_min = 0.12;  ///< least probability a cell may reach
  double clamp_max = 0.97;  ///< greatest probability a cell may reach

  template <class Visitor>
  void describe(Visitor& v) {
    v.field("hit", hit, "", "probability of occupied, given that a beam ended in the cell", {0.5, 0.999, true});
    v.field("miss", miss, "", "probability of occupied, given that a beam passed the cell", between(0.001, 0.499));
    v.field("clamp_min", clamp_min, "", "least probability that a cell may reach", between(0.001, 0.499));
    v.field("clamp_max", clamp_max, "", "greatest probability that a cell may reach", {0.5, 0.999, true});
  }
};

/// A probability as log-odds, with OctoMap's precision.
inline float logOdds(double probability) { return static_cast<float>(std::log(probability / (1.0 - probability))); }

/// Log-odds as a probability.
inline double probability(float log_odds) { return 1.0 - 1.0 / (1.0 + std::exp(static_cast<double>(log_odds))); }

/// The model in log-odds; `min` and `max` are the clamping bounds.
struct LogOddsModel {
  float hit, miss, min, max;

  explicit LogOddsModel(const OccupancyModel& model)
      : hit(logOdds(model.hit)),
        miss(logOdds(model.miss)),
        min(logOdds(model.clamp_min)),
        max(logOdds(model.clamp_max)) {}
  float clamp(float log_odds) const { return std::min(std::max(log_odds, min), max); }
};

}  // namespace frontier_pilot::occupancy
