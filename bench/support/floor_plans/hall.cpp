#include <algorithm>

#include "support/floor_plans/building.h"

namespace frontier_pilot::bench {
namespace {

const RoomKinds kCabins = {{RoomUse::kOffice, 50, cm(300), cm(500)},
                           {RoomUse::kStorage, 20, cm(250), cm(500)},
                           {RoomUse::kToilets, 20, cm(250), cm(400)},
                           {RoomUse::kKitchen, 10, cm(300), cm(420)}};

/// How the rows of shelves of a hall stand [cells].
struct ShelfRows {
  int depth = 0;   ///< of a row
  int aisle = 0;   ///< between rows
  int length = 0;  ///< of a row, up to the next cross aisle
  int cross = 0;   ///< width of a cross aisle
};

/// A row of shelves of 2.7 m each or less, of which some are missing.
void shelfRow(Furnisher& room, PlanRandom& random, int x, int y, int length, int depth) {
  const int bay = cm(270);
  for (int at = 0; at < length; at += bay) {
    if (random.chance(8)) continue;
    room.at(Side::kSouth, {x + at, y}, box(std::min(bay, length - at), depth));
  }
}

void shelves(Furnisher& room, PlanRandom& random, const CellRect& zone, const ShelfRows& rows) {
  const int columns = std::max(1, (zone.width + rows.cross) / (rows.length + rows.cross));
  const int length = (zone.width - (columns - 1) * rows.cross) / columns;
  for (int y = 0; y + rows.depth <= zone.height; y += rows.depth + rows.aisle) {
    for (int i = 0; i < columns; ++i) {
      shelfRow(room, random, zone.x + i * (length + rows.cross), zone.y + y, length, rows.depth);
    }
  }
}

/// Goods on the floor in a loose raster, as pallets wait for a lorry.
void pallets(Furnisher& room, PlanRandom& random, const CellRect& zone) {
  const int pitch = cm(200);
  for (int y = 0; y + pitch <= zone.height; y += pitch) {
    for (int x = 0; x + pitch <= zone.width; x += pitch) {
      if (random.chance(55)) continue;
      const int jitter = random.between(0, cm(10));
      const bool along = random.chance(70);
      room.at(Side::kSouth, {zone.x + x + jitter, zone.y + y + jitter},
              along ? box(cm(120), cm(80)) : box(cm(80), cm(120)));
    }
  }
}

void columns(Furnisher& room, PlanRandom& random) {
  const int pitch = cm(random.oneOf({600, 750, 900}));
  const int side = cm(random.oneOf({30, 40, 50}));
  const bool round = random.chance(40);
  const WallFrame frame = room.frame(Side::kSouth);
  for (int y = pitch; y < frame.depth() - pitch / 2; y += pitch) {
    for (int x = pitch; x < frame.length() - pitch / 2; x += pitch) {
      room.at(Side::kSouth, {x, y}, round ? column(side) : box(side, side));
    }
  }
}

void warehouse(Furnisher& room, PlanRandom& random) {
  const CellRect& area = room.room();
  const int margin = cm(random.between(180, 250));
  const int dock = std::min(area.width / 4, cm(random.between(450, 700)));
  const ShelfRows rows{cm(random.oneOf({100, 120, 220})), cm(random.between(180, 300)), cm(random.between(900, 1600)),
                       cm(random.between(200, 300))};
  shelves(room, random, {dock, margin, area.width - dock - margin, area.height - 2 * margin}, rows);
  pallets(room, random, {cm(60), margin, dock - cm(120), area.height - 2 * margin});
}

void shop(Furnisher& room, PlanRandom& random) {
  const CellRect& area = room.room();
  const int front = cm(random.between(350, 500));
  const ShelfRows rows{cm(90), cm(random.between(140, 200)), cm(random.between(400, 700)),
                       cm(random.between(180, 240))};
  const int margin = cm(60) + rows.aisle;
  shelves(room, random, {front, margin, area.width - front - margin, area.height - 2 * margin}, rows);
  for (const Side wall : {Side::kSouth, Side::kNorth, Side::kEast}) {
    for (int i = 0; i < room.frame(wall).length() / cm(600); ++i)
      room.against(wall, box(cm(random.between(300, 500)), cm(50)));
  }
  for (int y = margin; y + cm(60) < area.height - margin; y += cm(220)) {
    if (random.chance(80)) room.at(Side::kSouth, {front / 3, y}, box(cm(180), cm(60)));
  }
}

void workshop(Furnisher& room, PlanRandom& random) {
  const CellRect& area = room.room();
  const int pitch_x = cm(random.between(480, 560));
  const int pitch_y = cm(random.between(400, 480));
  for (int y = cm(200); y + cm(260) <= area.height - cm(120); y += pitch_y) {
    for (int x = cm(200); x + cm(380) <= area.width - cm(120); x += pitch_x) {
      const Side side = random.oneOf({Side::kSouth, Side::kNorth});
      const Furniture piece = random.chance(75) ? machine(random) : table(cm(240), cm(100));
      const int from_wall = side == Side::kSouth ? y : area.height - y - piece.depth;
      if (random.chance(85)) room.at(side, {x + random.between(0, cm(40)), from_wall}, piece);
    }
  }
  for (int i = 0; i < (area.width + area.height) / cm(500); ++i) {
    const Side wall = random.oneOf({Side::kSouth, Side::kNorth, Side::kWest, Side::kEast});
    room.against(wall, box(cm(random.between(150, 320)), cm(random.oneOf({60, 80}))));
  }
}

void equip(Building& plan, PlanRandom& random, const CellRect& area, Cell entrance) {
  Furnisher furnisher(plan.draft(), random, area, entrance);
  columns(furnisher, random);
  switch (random.between(0, 2)) {
    case 0:
      warehouse(furnisher, random);
      break;
    case 1:
      shop(furnisher, random);
      break;
    default:
      workshop(furnisher, random);
      break;
  }
  furnisher.finish();
}

}  // namespace

// One or two halls side by side, with gates between them, and cabins along the south.
Building hall(int area, PlanRandom& random) {
  const int wall = cm(random.oneOf({15, 20, 25}));
  const int aspect = random.between(110, 190);  // [%]
  int height = cm(900);
  while (widthFor(area, height) * 100 > aspect * height) ++height;
  const int width = widthFor(area, height);
  Building plan(width, height, wall, random);

  const int cabins = cm(random.between(300, 400));
  const int cabins_width = std::min(width, width * random.between(40, 100) / 100);
  const int y = cabins + wall;
  const bool two = area > 550 && random.chance(50);
  const int split = two ? width * random.between(40, 60) / 100 : width;
  const CellRect west{0, y, split, height - y};
  const CellRect east{split + wall, y, width - split - wall, height - y};
  plan.shell(west);
  if (two) plan.shell(east);
  const int entry = west.height / 2;
  const CellRect start{0, y + entry - cm(100), cm(200), cm(200)};
  plan.corridor(start);
  plan.draft().keepClear(start);
  const int gate = cm(random.between(200, 320));
  Cell in_east{};
  if (two) {
    plan.doorBetween(west, Side::kEast, gate, 0, west.height / 2);
    in_east = plan.doorBetween(east, Side::kWest, gate, east.height / 2, east.height);
  }
  plan.row({0, 0, cabins_width, cabins}, Side::kNorth, kCabins);
  equip(plan, random, west, {start.x + cm(100), start.y + cm(100)});
  if (two) equip(plan, random, east, in_east);
  return plan;
}

}  // namespace frontier_pilot::bench
