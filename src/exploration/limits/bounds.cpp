#include <algorithm>
#include <cstdio>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/outline.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {
namespace {

std::string nameOf(std::size_t keep_out) { return "keep_out[" + std::to_string(keep_out) + "]"; }

std::string sized(const std::vector<Vec2>& corners) {
  char text[64];
  std::snprintf(text, sizeof text, "%zu corners, %.1f m2", corners.size(), polygonArea(corners));
  return text;
}

std::string problemOf(const std::string& name, const std::vector<Vec2>& corners) {
  const bool near = std::all_of(corners.begin(), corners.end(), [](const Vec2& corner) {
    return bounds::isWithin(corner.x(), bounds::kMostCoordinate) &&
           bounds::isWithin(corner.y(), bounds::kMostCoordinate);
  });
  if (!near) return name + ": a corner is not finite or farther than 1000 km away";
  const std::string wrong = polygonProblem(corners);
  return wrong.empty() ? wrong : name + ": " + wrong;
}

}  // namespace

bool ExplorationBounds::contain(const Vec2& point) const {
  const bool within = stay_within.empty() || polygonContains(stay_within, point);
  return within && std::none_of(keep_out.begin(), keep_out.end(),
                                [&](const std::vector<Vec2>& area) { return polygonContains(area, point); });
}

std::string ExplorationBounds::problem() const {
  std::size_t corners = stay_within.size();
  for (const std::vector<Vec2>& area : keep_out) corners += area.size();
  if (corners > bounds::kMostBoundsCorners) return "the bounds must have at most 2000 corners together";
  if (!stay_within.empty()) {
    std::string wrong = problemOf("stay_within", stay_within);
    if (!wrong.empty()) return wrong;
  }
  for (std::size_t i = 0; i < keep_out.size(); ++i) {
    std::string wrong = problemOf(nameOf(i), keep_out[i]);
    if (!wrong.empty()) return wrong;
  }
  return {};
}

std::string ExplorationBounds::describe() const {
  std::string text = stay_within.empty() ? "stay within: everywhere" : "stay within: " + sized(stay_within);
  for (const std::vector<Vec2>& area : keep_out) text += "; keep out of: " + sized(area);
  return text;
}

ExplorationBounds BoundsParameters::polygons() const {
  ExplorationBounds polygons;
  polygons.stay_within = cornersOf(stay_within);
  for (const std::vector<double>& area : keep_out) polygons.keep_out.push_back(cornersOf(area));
  return polygons;
}

void BoundsParameters::check(Problems& problems) const {
  if (stay_within.size() % 2 != 0) problems.emplace_back("stay_within: must be pairs x, y");
  for (std::size_t i = 0; i < keep_out.size(); ++i) {
    if (keep_out[i].size() % 2 != 0) problems.push_back(nameOf(i) + ": must be pairs x, y");
  }
  const std::string wrong = polygons().problem();
  if (!wrong.empty()) problems.push_back(wrong);
}

}  // namespace frontier_pilot::exploration
