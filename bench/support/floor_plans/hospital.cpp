#include "support/floor_plans/ladder_floor.h"

#include <algorithm>

namespace frontier_pilot::bench {
namespace {

const RoomKinds kWard = {{RoomUse::kPatients, 70, cm(340), cm(440)},
                         {RoomUse::kStorage, 10, cm(200), cm(300)},
                         {RoomUse::kNurseBase, 8, cm(420), cm(560), true},
                         {RoomUse::kExamination, 8, cm(300), cm(400)},
                         {RoomUse::kBath, 6, cm(220), cm(300)}};
const RoomKinds kService = {{RoomUse::kExamination, 40, cm(300), cm(450)},
                            {RoomUse::kOffice, 15, cm(280), cm(380)},
                            {RoomUse::kStorage, 20, cm(180), cm(320)},
                            {RoomUse::kToilets, 12, cm(240), cm(360)},
                            {RoomUse::kWaiting, 13, cm(350), cm(550), true}};

/// Wings side by side that stand on a common corridor, with courtyards between them.
Building comb(int area, int wings, PlanRandom& random) {
  const int wall = cm(random.oneOf({10, 15, 20}));
  const int corridor = cm(random.between(210, 260));
  const int depth = cm(random.between(500, 580));
  const int service = cm(random.between(380, 460));
  const int wing_width = 2 * depth + corridor + 2 * wall;
  const int court = cm(random.between(300, 700));
  const int width = wings * wing_width + (wings - 1) * court;
  const int y_wings = service + corridor + 2 * wall;
  const int length = std::max(cm(700), (area * 400 - width * y_wings) / (wings * wing_width));
  Building plan(width, y_wings + length, wall, random);
  plan.corridor({0, service + wall, width, corridor});
  for (int i = 0; i < wings; ++i) {
    const int x = i * (wing_width + court);
    plan.corridor({x + depth + wall, y_wings - wall, corridor, length + wall});
  }
  for (int i = 0; i < wings; ++i) {
    const int x = i * (wing_width + court);
    plan.row({x, y_wings, depth, length}, Side::kEast, kWard);
    plan.row({x + depth + corridor + 2 * wall, y_wings, depth, length}, Side::kWest, kWard);
  }
  plan.row({0, 0, width, service}, Side::kNorth, kService);
  return plan;
}

}  // namespace

Building hospitalWing(int area, PlanRandom& random) {
  if (area < 500 || random.chance(50)) return comb(area, area < 500 ? 1 : area < 950 ? 2 : 3, random);
  LadderStyle style;
  style.outer = kWard;
  style.middle = kService;
  style.ends = {{RoomUse::kExamination, 60, cm(300), cm(420)}, {RoomUse::kWaiting, 40, cm(300), cm(500), true}};
  style.corridor = cm(random.between(210, 250));
  style.depth = cm(random.between(500, 570));
  return ladderFloor(area, style, random);
}

}  // namespace frontier_pilot::bench
