#include "support/floor_plans/ladder_floor.h"

namespace frontier_pilot::bench {

Building officeFloor(int area, PlanRandom& random) {
  LadderStyle style;
  style.outer = {{RoomUse::kOffice, 55, cm(260), cm(480)},
                 {RoomUse::kOpenPlan, 20, cm(800), cm(1500), true},
                 {RoomUse::kMeeting, 15, cm(380), cm(650)},
                 {RoomUse::kKitchen, 6, cm(300), cm(450)}};
  style.middle = {{RoomUse::kOffice, 20, cm(260), cm(420)},
                  {RoomUse::kStorage, 20, cm(200), cm(350)},
                  {RoomUse::kToilets, 20, cm(240), cm(420)},
                  {RoomUse::kMeeting, 25, cm(350), cm(600)},
                  {RoomUse::kWaiting, 8, cm(300), cm(450), true}};
  style.ends = {{RoomUse::kOffice, 60, cm(260), cm(400)},
                {RoomUse::kMeeting, 20, cm(350), cm(500)},
                {RoomUse::kWaiting, 10, cm(300), cm(500), true}};
  style.corridor = cm(random.between(150, 210));
  style.depth = cm(random.between(400, 520));
  return ladderFloor(area, style, random);
}

}  // namespace frontier_pilot::bench
