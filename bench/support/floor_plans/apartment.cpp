#include "support/floor_plans/building.h"

#include <algorithm>

namespace frontier_pilot::bench {
namespace {

const RoomKinds kSunnySide = {{RoomUse::kBedroom, 60, cm(280), cm(430)}, {RoomUse::kStudy, 25, cm(240), cm(360)}};
const RoomKinds kOtherSide = {{RoomUse::kBath, 35, cm(180), cm(260)},
                              {RoomUse::kStorage, 15, cm(150), cm(220)},
                              {RoomUse::kStudy, 20, cm(240), cm(340)},
                              {RoomUse::kBedroom, 30, cm(270), cm(380)}};

}  // namespace

// The living room takes the whole west end; a hall leads from it past bedrooms in the south, and past kitchen, bath and
// small rooms in the north. The kitchen has a second door, to the living room.
Building apartment(int area, PlanRandom& random) {
  const int wall = cm(random.oneOf({10, 15, 20}));
  const int hall = cm(random.between(120, 170));
  const int south = cm(random.between(360, 420) + area / 2);
  const int north = cm(random.between(260, 310) + area / 3);
  const int height = south + hall + north + 2 * wall;
  const int width = widthFor(area, height);
  Building plan(width, height, wall, random);

  const int living_width = std::max(cm(400), std::min(cm(700), width * random.between(30, 38) / 100));
  const CellRect living{0, 0, living_width, height};
  const int x = living_width + wall;
  plan.corridor({x, south + wall, width - x, hall});
  plan.shell(living);
  const int kitchen_width = std::min(cm(random.between(240, 380)), width - x - cm(200));
  const CellRect kitchen{x, height - north, kitchen_width, north};
  plan.shell(kitchen);
  const int door = cm(random.oneOf({90, 100, 140, 160}));
  const Cell from_hall =
      plan.doorBetween(living, Side::kEast, std::min(door, hall - cm(30)), south + wall, south + wall + hall);
  plan.doorBetween(living, Side::kEast, cm(random.oneOf({90, 160})), height - north, height);
  plan.furnish(living, Side::kEast, RoomUse::kLiving, from_hall);
  plan.furnish(kitchen, Side::kSouth, RoomUse::kKitchen, plan.door(kitchen, Side::kSouth, cm(90)));

  const int bath = x + kitchen_width + wall;
  const int bath_width = cm(random.between(190, 280));
  plan.room({bath, height - north, bath_width, north}, Side::kSouth, RoomUse::kBath);
  const int rest = bath + bath_width + wall;
  if (width - rest >= cm(140)) plan.row({rest, height - north, width - rest, north}, Side::kSouth, kOtherSide);
  plan.row({x, 0, width - x, south}, Side::kNorth, kSunnySide);
  return plan;
}

}  // namespace frontier_pilot::bench
