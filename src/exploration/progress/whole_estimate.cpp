#include "exploration/progress/whole_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace frontier_pilot::exploration {
namespace {

/// The area left [m^2], a little too large when nothing is in sight.
double areaLeft(const ExplorationRecord& record) {
  constexpr double kScale = 2.3;
  constexpr double kLeastInSight = 0.2;  // [m^2]
  return kScale * std::pow(record.area_in_sight + kLeastInSight, 1.13) * std::pow(record.explored_area, -0.4);
}

/// By the rate at which the area has grown so far, and the part of the way that the tour is; NaN if it has not grown.
double timeLeft(const ExplorationRecord& record, double area_left) {
  constexpr double kLeast = 2.0;  // [m], so that short ways do not count too much
  const double gained = record.explored_area - record.explored_before;
  if (gained <= 0.0) return std::numeric_limits<double>::quiet_NaN();
  const double growth = area_left / gained;
  if (record.tour_length <= 0.0) return 2.9 * record.time * std::pow(growth, 0.7);
  const double way = (record.tour_length + kLeast) / (record.distance + kLeast);
  return 3.1 * record.time * std::pow(growth, 0.22) * std::pow(way, 0.81);
}

}  // namespace

std::optional<WholeEstimate> estimateWhole(const ExplorationRecord& record) {
  constexpr double kSoonest = 10.0;  // [s]
  constexpr double kAtEnd = 0.5;     // [m^2]: what areaLeft is too large by at the end
  if (record.time < kSoonest || record.explored_area <= 0.0) return std::nullopt;
  const double left = areaLeft(record);
  WholeEstimate estimate;
  estimate.area = record.explored_area + std::max(0.0, left - kAtEnd);
  estimate.deviation = left;
  estimate.time_left = timeLeft(record, left);
  estimate.explored = record.explored_area;
  return estimate;
}

}  // namespace frontier_pilot::exploration
