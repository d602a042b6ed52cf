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
  int iterations = 12;         ///< greatest number of Gauss-Newton steps
  double outlier = 0.05;       ///< the weight of a point this far from its surface is a quarter [m]
  double independence = 0.25;  ///< share of the points that counts as independent measurements

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"iterations", "outlier", "independence"});
  }
};

}  // namespace frontier_pilot::scan_matching
