#include "support/floor_plans/ladder_floor.h"

#include <algorithm>

namespace frontier_pilot::bench {
namespace {

/// Two rows back to back where `area` is deep enough for that, otherwise one.
void middleBlock(Building& plan, const CellRect& area, const RoomKinds& kinds, PlanRandom& random) {
  if (area.height < cm(650)) {
    return plan.row(area, random.chance(50) ? Side::kSouth : Side::kNorth, kinds);
  }
  const int south = (area.height - plan.wall()) * random.between(45, 55) / 100;
  const int north = area.height - plan.wall() - south;
  plan.row({area.x, area.y, area.width, south}, Side::kSouth, kinds);
  plan.row({area.x, area.y + area.height - north, area.width, north}, Side::kNorth, kinds);
}

/// The blocks between the long corridors, and the cross corridors between the blocks.
void middleBand(Building& plan, const CellRect& band, const LadderStyle& style, PlanRandom& random) {
  const int wall = plan.wall();
  const int cross = std::max(cm(150), style.corridor * random.between(80, 100) / 100);
  const int end = std::min(cm(random.between(380, 480)), band.width / 5);
  const bool west = random.chance(60);
  const bool east = random.chance(60);
  const int from = west ? end + wall : 0;
  const int to = band.width - (east ? end + wall : 0);
  const int blocks = std::max(1, (to - from) / cm(1600));
  const int width = (to - from - (blocks + 1) * cross - 2 * blocks * wall) / blocks;
  int x = band.x + from;
  for (int i = 0; i <= blocks; ++i) {
    const int last = i == blocks ? band.x + to - x : cross;
    plan.corridor({x, band.y - wall, last, band.height + 2 * wall});
    x += last + width + 2 * wall;
  }
  if (west) plan.row({band.x, band.y, end, band.height}, Side::kEast, style.ends);
  if (east) plan.row({band.x + band.width - end, band.y, end, band.height}, Side::kWest, style.ends);
  x = band.x + from + cross + wall;
  for (int i = 0; i < blocks; ++i, x += width + cross + 2 * wall) {
    middleBlock(plan, {x, band.y, width, band.height}, style.middle, random);
  }
}

}  // namespace

Building ladderFloor(int area, const LadderStyle& style, PlanRandom& random) {
  const int wall = cm(random.oneOf({10, 15, 20, 25}));
  const int north = area < 450 ? 0 : style.depth * random.between(85, 115) / 100;
  const int south = style.depth;
  const int middle = cm(area < 450 ? random.between(340, 420) : random.between(450, 600) + area / 4);
  const int walls = (north > 0 ? 4 : 3) * wall;
  const int height = south + middle + north + 2 * style.corridor + walls;
  const int width = widthFor(area, height);
  Building plan(width, height, wall, random);
  const int y_south = south + wall;
  const int y_band = y_south + style.corridor + wall;
  const int y_north = y_band + middle + wall;
  plan.corridor({0, y_south, width, style.corridor});
  plan.corridor({0, y_north, width, style.corridor});
  middleBand(plan, {0, y_band, width, middle}, style, random);
  plan.row({0, 0, width, south}, Side::kNorth, style.outer);
  if (north > 0) plan.row({0, height - north, width, north}, Side::kSouth, style.outer);
  return plan;
}

}  // namespace frontier_pilot::bench
