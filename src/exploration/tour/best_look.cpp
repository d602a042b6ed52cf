#include "exploration/tour/best_look.h"

#include <algorithm>

namespace frontier_pilot::exploration {
namespace {

/// The first of `width` successive rays, around the circle, that together show most.
int bestStart(const std::vector<double>& areas, int width) {
  const int rays = static_cast<int>(areas.size());
  const auto area = [&](int ray) { return areas[static_cast<std::size_t>(ray % rays)]; };
  double sum = 0.0;
  for (int i = 0; i < width; ++i) sum += area(i);
  double most = sum;
  int best = 0;
  for (int start = 1; start < rays; ++start) {
    sum += area(start + width - 1) - area(start - 1);
    if (sum <= most) continue;
    most = sum;
    best = start;
  }
  return best;
}

}  // namespace

Look bestLook(const std::vector<Glimpse>& glimpses, const ViewParameters& parameters) {
  if (parameters.allAround() || glimpses.empty()) return {};
  const int rays = parameters.rays;
  const double step = 2.0 * kPi / rays;
  const int width = std::clamp(static_cast<int>(parameters.field_of_view / step), 1, rays);
  std::vector<double> areas(static_cast<std::size_t>(rays), 0.0);
  for (const Glimpse& glimpse : glimpses) areas[glimpse.ray] += glimpse.area;
  const int start = bestStart(areas, width);
  int first = width, last = 0;  // of the rays that show anything, counted from the start
  for (const Glimpse& glimpse : glimpses) {
    const int place = (glimpse.ray - start + rays) % rays;
    if (place >= width) continue;
    first = std::min(first, place);
    last = std::max(last, place);
  }
  return {parameters.yawTowards((start + 0.5 * (first + last)) * step),
          0.5 * (parameters.field_of_view - (last - first) * step)};
}

double nearestYaw(const Look& look, double wanted) {
  if (look.slack >= kPi) return wanted;
  return normalizeAngle(look.yaw + std::clamp(angleDifference(wanted, look.yaw), -look.slack, look.slack));
}

}  // namespace frontier_pilot::exploration
