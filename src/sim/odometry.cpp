#include "frontier_pilot/sim/odometry.h"

#include <cmath>

namespace frontier_pilot::sim {

void Odometry::move(double length, double turn, double seconds) {
  twist_ = {length / seconds, turn / seconds};
  if (twist_.isZero()) return;
  Twist2 measured{length, turn};
  if (noisy_) {
    const double driven = std::abs(length);
    const double turned = std::abs(turn);
    // Variances in the motion, not in its square, add up to the same however finely a path is cut.
    measured.linear += std::sqrt(parameters_.alpha3 * driven + parameters_.alpha4 * turned) * random_.gaussian();
    measured.angular += std::sqrt(parameters_.alpha1 * turned + parameters_.alpha2 * driven) * random_.gaussian();
  }
  pose_ = integrate(pose_, measured, 1.0);
}

void Odometry::reset() {
  pose_ = {};
  twist_ = {};
}

}  // namespace frontier_pilot::sim
