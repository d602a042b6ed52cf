#include "support/floor_plans/building.h"

#include <algorithm>
#include <limits>

namespace frontier_pilot::bench {
namespace {

constexpr int kJamb = cm(15);  ///< between a door and the nearest corner

/// The door's width that is usual for a room.
int doorWidth(RoomUse use, PlanRandom& random) {
  switch (use) {
    case RoomUse::kPatients:
      return cm(120);
    case RoomUse::kBath:
    case RoomUse::kToilets:
      return cm(random.oneOf({80, 85, 90}));
    case RoomUse::kMeeting:
    case RoomUse::kLiving:
      return cm(random.oneOf({90, 100, 140, 160}));
    case RoomUse::kExamination:
      return cm(random.oneOf({100, 120, 160}));
    default:
      break;
  }
  return cm(random.oneOf({80, 90, 90, 100, 110, 120}));
}

/// The side of a frame in which its x axis ends.
Side endOf(Side front) { return front == Side::kSouth || front == Side::kNorth ? Side::kEast : Side::kNorth; }

Cell cornerOf(const CellRect& area) { return {area.x, area.y}; }

}  // namespace

void Building::corridor(const CellRect& area) {
  draft_.carve(area);
  corridors_.push_back(area);
}

Cell Building::doorBetween(const CellRect& area, Side side, int width, int low, int high) {
  const int first = low + kJamb;
  const int last = std::max(first, high - kJamb - width);
  // Doors are near a corner more often than not.
  const int offset = random_.chance(60) ? (random_.chance(50) ? first : last) : random_.between(first, last);
  draft_.addDoor(area, side, offset, width, wall_);
  return cornerOf(WallFrame(area, side).cells({offset + width / 2, cm(45), 1, 1}));
}

Cell Building::door(const CellRect& area, Side side, int width) {
  return doorBetween(area, side, width, 0, WallFrame(area, side).length());
}

Cell Building::opening(const CellRect& area, Side side, int low, int high) {
  draft_.addDoor(area, side, low, high - low, wall_);
  return cornerOf(WallFrame(area, side).cells({(low + high) / 2, cm(45), 1, 1}));
}

void Building::furnish(const CellRect& area, Side front, RoomUse use, Cell entrance) {
  Furnisher furnisher(draft_, random_, area, entrance);
  bench::furnish(furnisher, random_, front, use);
}

// A room for patients has a wet cell in the corner beside its door.
Cell Building::patientsDoor(const CellRect& area, Side front) {
  const WallFrame frame(area, front);
  const int width = cm(180);
  const int depth = cm(200);
  const int door = doorWidth(RoomUse::kPatients, random_);
  if (frame.length() < width + wall_ + door + 2 * kJamb || frame.depth() < cm(450))
    return this->door(area, front, door);
  const bool low = random_.chance(50);
  const int x = low ? 0 : frame.length() - width;
  draft_.wall(frame.cells({low ? 0 : x - wall_, 0, width + wall_, depth + wall_}));
  const CellRect cell = frame.cells({x, 0, width, depth});
  shell(cell);
  const Cell entrance = low ? doorBetween(area, front, door, width + wall_, frame.length())
                            : doorBetween(area, front, door, 0, x - wall_);
  const Side exit = low ? endOf(front) : opposite(endOf(front));
  furnish(cell, exit, RoomUse::kBath, this->door(cell, exit, cm(90)));
  return entrance;
}

void Building::room(const CellRect& area, Side front, RoomUse use, bool open) {
  shell(area);
  const int length = WallFrame(area, front).length();
  if (open) return furnish(area, front, use, opening(area, front, cm(40), length - cm(40)));
  if (use == RoomUse::kPatients) return furnish(area, front, use, patientsDoor(area, front));
  const int width = doorWidth(use, random_);
  const Cell entrance = door(area, front, width);
  if (length > cm(900)) door(area, front, width);
  furnish(area, front, use, entrance);
}

RoomKind Building::draw(const RoomKinds& kinds, int most) {
  RoomKinds fitting;
  int sum = 0;
  for (const RoomKind& kind : kinds) {
    if (kind.least > most) continue;
    fitting.push_back(kind);
    sum += kind.weight;
  }
  if (fitting.empty()) return kinds.front();
  int ticket = random_.between(1, sum);
  for (const RoomKind& kind : fitting) {
    ticket -= kind.weight;
    if (ticket <= 0) return kind;
  }
  return fitting.back();
}

void Building::row(const CellRect& area, Side front, const RoomKinds& kinds) {
  int least = std::numeric_limits<int>::max();
  for (const RoomKind& kind : kinds) least = std::min(least, kind.least);
  const WallFrame frame(area, front);
  int width = 0;
  for (int x = 0; x < frame.length(); x += width + wall_) {
    const int left = frame.length() - x;
    const RoomKind kind = draw(kinds, left);
    width = std::min(left, random_.between(kind.least, kind.most));
    if (left - width < wall_ + least) width = left;
    room(frame.cells({x, 0, width, frame.depth()}), front, kind.use, kind.open);
  }
}

}  // namespace frontier_pilot::bench
