#include "exploration/tour/passages.h"

#include "exploration/view_gain.h"

namespace frontier_pilot::exploration {
namespace {

constexpr double kRoomy = 0.45;  ///< [m], radius of a disc that does not fit into a passage
constexpr double kNear = 1.2;    ///< [m]: half the side of the square in which such a disc is looked for

bool isFreeDisc(const OccupancyGrid& map, Cell centre, int radius) {
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      const bool inside = dx * dx + dy * dy <= radius * radius;
      if (inside && !isFree(map.get({centre.x + dx, centre.y + dy}, kOccupied))) return false;
    }
  }
  return true;
}

bool isInPassage(Cell frontier, const OccupancyGrid& map) {
  constexpr int kStep = 2;  // cells
  const int near = static_cast<int>(kNear / map.resolution());
  const int radius = static_cast<int>(kRoomy / map.resolution());
  for (int y = frontier.y - near; y <= frontier.y + near; y += kStep) {
    for (int x = frontier.x - near; x <= frontier.x + near; x += kStep) {
      if (isFreeDisc(map, {x, y}, radius) && inSight(map, {x, y}, frontier)) return false;
    }
  }
  return true;
}

}  // namespace

bool Passages::contains(Cell frontier, const ObservedMap& map) {
  constexpr std::size_t kMostJudged = 20000;
  if (geometry_ != map.geometry() || judged_.size() > kMostJudged) judged_.clear();
  geometry_ = map.geometry();
  const std::uint64_t changes = map.changesAround(geometry_.centre(frontier), kNear + kRoomy) + 1;
  Judgement& judgement = judged_[geometry_.index(frontier)];
  if (judgement.changes != changes) judgement = {changes, isInPassage(frontier, map.grid())};
  return judgement.in_passage;
}

}  // namespace frontier_pilot::exploration
