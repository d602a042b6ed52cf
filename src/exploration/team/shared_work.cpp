#include "exploration/team/shared_work.h"

#include <algorithm>

#include "exploration/tour/unknown_region.h"

namespace frontier_pilot::exploration {
namespace {

constexpr double kSamePlace = 1.0;       // [m]: clusters are cut at different cells in different maps
constexpr double kSameArea = 3.0;        // [m]: how far the unknown behind a frontier counts as one area
constexpr double kClearly = 0.15;        // a taker has to be better by this share of the other's cost,
constexpr double kClearlySeconds = 3.0;  // and this time [s]

/// Whether `place` [m] lies in or beside one of `cells`.
bool borders(const std::vector<Cell>& cells, Cell place) {
  constexpr int kBeside = 2;  // [cells]
  return std::any_of(cells.begin(), cells.end(),
                     [&](Cell c) { return std::abs(c.x - place.x) <= kBeside && std::abs(c.y - place.y) <= kBeside; });
}

}  // namespace

void SharedWork::setOthers(const std::vector<Teammate>& others) {
  others_ = others;
  restart();
}

bool SharedWork::othersHaveWork() const {
  return std::any_of(others_.begin(), others_.end(), [](const Teammate& other) { return !other.claims.empty(); });
}

bool SharedWork::leaves(Cell anchor, double cost, const ObservedMap& map) {
  if (alone()) return false;
  const std::optional<Rival>& rival = rivalFor(anchor, map);
  if (!rival) return false;
  const bool held = holds(map.geometry().centre(anchor));
  const double margin = held ? 0.0 : kClearlySeconds + kClearly * rival->cost;
  const double advantage = rival->cost - cost;
  return advantage < margin || (advantage == margin && rival->precedes);
}

const std::optional<SharedWork::Rival>& SharedWork::rivalFor(Cell anchor, const ObservedMap& map) {
  const auto [known, is_new] = rivals_.try_emplace(map.geometry().index(anchor));
  if (is_new) known->second = findRival(anchor, map);
  return known->second;
}

std::optional<SharedWork::Rival> SharedWork::findRival(Cell anchor, const ObservedMap& map) const {
  const Vec2 place = map.geometry().centre(anchor);
  std::optional<Rival> best;
  std::optional<std::vector<Cell>> area;
  for (const Teammate& other : others_) {
    for (const Claim& claim : other.claims) {
      if (best && claim.cost >= best->cost) continue;
      const double distance = (claim.place - place).norm();
      if (distance > kSameArea + kSamePlace) continue;
      if (distance > kSamePlace) {
        if (!area) area = unknownBehind(map.grid(), anchor, kSameArea);
        if (!borders(*area, map.geometry().cellAt(claim.place))) continue;
      }
      best = Rival{claim.cost, other.precedes};
    }
  }
  return best;
}

bool SharedWork::holds(const Vec2& place) const {
  return std::any_of(own_.begin(), own_.end(),
                     [&](const Claim& claim) { return (claim.place - place).norm() <= kSamePlace; });
}

}  // namespace frontier_pilot::exploration
