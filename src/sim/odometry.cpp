#include "sim/odometry.h"

#include <cmath>

namespace frontier_pilot::sim {

Odometry::Odometry(const OdometryParameters& parameters, bool noisy, const Random& random)
    : parameters_(parameters), noisy_(noisy), random_(random) {
  // A random number is drawn only for an error that is enabled: one that is disabled must not change the other noise.
  const auto drawn = [&](double deviation) { return noisy && deviation > 0.0 ? deviation * random_.gaussian() : 0.0; };
  distance_factor_ += drawn(parameters.distance_scale);
  turn_factor_ += drawn(parameters.turn_scale);
  drift_ = drawn(parameters.drift);
}

void Odometry::move(double length, double turn, double seconds) {
  twist_ = {length / seconds, turn / seconds};
  if (twist_.isZero()) return;
  Twist2 measured{distance_factor_ * length, turn_factor_ * turn + drift_ * length};
  if (noisy_) {
    const double driven = std::abs(length);
    const double turned = std::abs(turn);
    // Variances proportional to the motion, not to its square, add up to the same however finely a path is divided.
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
