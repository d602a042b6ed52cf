#pragma once

#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot::scan_matching {

/// The likelihood field of a SurfaceMap.
struct LikelihoodParameters {
  double resolution = 0.05;  ///< side of a cell [m]
  double sigma = 0.06;       ///< standard deviation of the Gaussian around each point [m]

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"resolution", "sigma"});
  }
};

/// How a match is refined, see `refine`.
struct RefinementParameters {
  int iterations = 12;         ///< at most
  double outlier = 0.05;       ///< a point this far from its surface counts a quarter [m]
  double independence = 0.25;  ///< share of the points that count as independent of each other

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"iterations", "outlier", "independence"});
  }
};

}  // namespace frontier_pilot::scan_matching
