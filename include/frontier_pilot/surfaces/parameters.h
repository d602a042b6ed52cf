#pragma once

#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot::surfaces {

/// How the surfaces of a scan are read, thinned and filled.
struct SurfaceParameters {
  double fit_radius = 0.2;       ///< neighbours within this take part in fitting a line [m]
  double fit_error = 0.025;      ///< greatest standard deviation of the neighbours from that line [m]
  double range_noise = 0.01;     ///< standard deviation of a range [m]
  double bearing_noise = 0.002;  ///< of a beam's direction [rad]
  double roughness = 0.003;      ///< least standard deviation of a surface about the line fitted to it [m]
  double thinning = 0.1;         ///< points this near to each other are matched as one [m]
  int max_points = 250;          ///< no more points than this are matched
  double fill_spacing = 0.05;    ///< gaps between beams on one surface are filled this densely [m]
  double max_gap = 1.5;          ///< wider gaps are not filled [m]

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"fit_radius", "fit_error", "range_noise", "bearing_noise", "roughness", "thinning", "max_points",
             "fill_spacing", "max_gap"});
  }
};

}  // namespace frontier_pilot::surfaces
