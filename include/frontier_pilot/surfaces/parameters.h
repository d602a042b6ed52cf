#pragma once

#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot::surfaces {

/// How the surfaces of a scan are read, thinned and filled.
struct SurfaceParameters {
  double fit_radius = 0.2;       ///< neighbours within this distance are used to fit a line [m]
  double fit_error = 0.025;      ///< greatest standard deviation of the neighbours from that line [m]
  double range_noise = 0.01;     ///< standard deviation of a range [m]
  double bearing_noise = 0.002;  ///< standard deviation of a beam's direction [rad]
  double roughness = 0.003;      ///< least standard deviation of a surface about the line fitted to it [m]
  double thinning = 0.1;         ///< points this near to each other are averaged before matching [m]
  int max_points = 250;          ///< greatest number of points that are matched
  double fill_spacing = 0.05;    ///< spacing of the points that fill gaps between beams on one surface [m]
  double max_gap = 1.5;          ///< wider gaps are not filled [m]

  template <class Visitor>
  void describe(Visitor& v) {
    v.fixed({"fit_radius", "fit_error", "range_noise", "bearing_noise", "roughness", "thinning", "max_points",
             "fill_spacing", "max_gap"});
  }
};

}  // namespace frontier_pilot::surfaces
