#include "support/floor_plans/furnisher.h"

#include <algorithm>

#include "sim/reachable_floor.h"

namespace frontier_pilot::bench {
namespace {

constexpr int kPassage = cm(60);  ///< between pieces that do not touch
constexpr int kWalkerRadius = cm(15);
constexpr int kLeastWalkable = 90;  ///< share of a room's floor that can be reached from its door [%]
constexpr int kPlacesTried = 8;     ///< random places that are tried for a piece

}  // namespace

bool Furnisher::keepsDistance(const CellRect& block, Side side) const {
  const WallFrame beyond(block, side);
  for (int d = 1; d <= kPassage; ++d) {
    for (int x = 0; x < beyond.length(); ++x) {
      const CellRect cell = beyond.cells({x, -d, 1, 1});
      if (draft_.isSolid({cell.x, cell.y})) return d == 1;
    }
  }
  return true;
}

bool Furnisher::fits(const CellRect& block) const {
  const CellRect inside = block.intersection(room_);
  if (!(inside == block) || !draft_.isOpen(block)) return false;
  for (const Side side : {Side::kSouth, Side::kNorth, Side::kWest, Side::kEast}) {
    if (!keepsDistance(block, side)) return false;
  }
  return true;
}

bool Furnisher::at(Side wall, Cell place, const Furniture& piece) {
  const WallFrame in_room = frame(wall);
  if (!fits(in_room.cells({place.x, place.y, piece.width, piece.depth}))) return false;
  for (const CellRect& part : piece.parts) {
    draft_.furnish(in_room.cells({place.x + part.x, place.y + part.y, part.width, part.height}));
  }
  placed_.push_back(in_room.cells({place.x, place.y, piece.width, piece.depth}));
  return true;
}

// Where a piece stands too near another one, it is moved until it touches that or has passed it.
bool Furnisher::tryNear(Side wall, Cell place, const Furniture& piece) {
  for (int shift = 0; shift <= kPassage; ++shift) {
    if (at(wall, {place.x - shift, place.y}, piece) || at(wall, {place.x + shift, place.y}, piece)) return true;
  }
  return false;
}

bool Furnisher::against(Side wall, const Furniture& piece) {
  const int most = frame(wall).length() - piece.width;
  if (most < 0) return false;
  for (int i = 0; i < kPlacesTried; ++i) {
    if (tryNear(wall, {random_.between(0, most), 0}, piece)) return true;
  }
  return false;
}

bool Furnisher::inCorner(Side wall, const Furniture& piece) {
  const int most = frame(wall).length() - piece.width;
  const bool first = random_.chance(50);
  return at(wall, {first ? 0 : most, 0}, piece) || at(wall, {first ? most : 0, 0}, piece) || against(wall, piece);
}

bool Furnisher::standing(Side wall, const Furniture& piece) {
  const int most_x = frame(wall).length() - piece.width - kPassage;
  const int most_y = frame(wall).depth() - piece.depth - kPassage;
  if (most_x < kPassage || most_y < kPassage) return false;
  for (int i = 0; i < kPlacesTried; ++i) {
    const Cell place{random_.between(kPassage, most_x), random_.between(kPassage, most_y)};
    if (at(wall, place, piece)) return true;
  }
  return false;
}

bool Furnisher::isWalkable() const {
  const CellRect part = room_.grown(kWalkerRadius + 1);
  const OccupancyGrid map = draft_.mapOf(part);
  const Grid<std::uint8_t> reached =
      sim::reachableFloor(map, {entrance_.x - part.x, entrance_.y - part.y}, kWalkerRadius);
  int floor = 0;
  int walkable = 0;
  for (int y = room_.y - part.y; y < room_.y - part.y + room_.height; ++y) {
    for (int x = room_.x - part.x; x < room_.x - part.x + room_.width; ++x) {
      floor += map[Cell{x, y}] == kFree ? 1 : 0;
      walkable += reached[Cell{x, y}];
    }
  }
  return 100 * walkable >= kLeastWalkable * floor;
}

void Furnisher::finish() {
  while (!placed_.empty() && !isWalkable()) {
    draft_.clearOut(placed_.back());
    placed_.pop_back();
  }
}

}  // namespace frontier_pilot::bench
