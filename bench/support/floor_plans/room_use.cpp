#include "support/floor_plans/room_use.h"

#include <algorithm>
#include <array>

namespace frontier_pilot::bench {
namespace {

/// Walls of a room as seen from its door.
enum class Wall {
  kFront,  ///< the door's
  kBack,
  kAside,  ///< one of the two beside the door's
  kOther,  ///< any but the door's
  kAny,
};

/// A room while it is furnished. C++ does not define in which order the arguments of a call draw random numbers:
/// therefore no call has two that do, and a wall is drawn after the piece that is to stand there.
struct Interior {
  Furnisher& room;
  PlanRandom& random;
  Side front;  ///< where the door is

  Side back() const { return opposite(front); }
  Side left() const { return front == Side::kSouth || front == Side::kNorth ? Side::kWest : Side::kSouth; }
  Side aside() const { return random.chance(50) ? left() : opposite(left()); }
  Side side(Wall wall) const {
    switch (wall) {
      case Wall::kFront:
        return front;
      case Wall::kBack:
        return back();
      case Wall::kAside:
        return aside();
      case Wall::kAny:
        if (random.chance(20)) return front;
        break;
      case Wall::kOther:
        break;
    }
    return random.oneOf({back(), left(), opposite(left())});
  }
  void against(Wall wall, const Furniture& piece) const { room.against(side(wall), piece); }
  void inCorner(Wall wall, const Furniture& piece) const { room.inCorner(side(wall), piece); }
  void standing(Wall wall, const Furniture& piece) const { room.standing(side(wall), piece); }
  int length() const { return room.frame(front).length(); }
  int depth() const { return room.frame(front).depth(); }
  /// The floor's area [m^2].
  int area() const { return length() * depth() / 400; }
};

Furniture shelf(PlanRandom& random, int least, int most) {
  const int width = random.between(cm(least), cm(most));
  return box(width, cm(random.oneOf({30, 35, 40})));
}

void living(const Interior& in) {
  const Side wall = in.aside();
  in.room.against(wall, sofa(in.random));
  in.room.against(opposite(wall), box(cm(in.random.between(140, 220)), cm(45)));
  const int table = cm(in.random.oneOf({140, 160, 200}));
  in.standing(Wall::kAny, tableWithChairs(table, cm(90), in.random.chance(20)));
  for (int i = 0; i < 1 + in.area() / 15; ++i) in.inCorner(Wall::kAny, shelf(in.random, 80, 240));
  if (in.area() > 28) in.standing(Wall::kAny, sofa(in.random));
  in.inCorner(Wall::kAny, column(cm(40)));
}

void kitchen(const Interior& in) {
  const int most = in.room.frame(in.back()).length();
  in.inCorner(Wall::kBack, box(std::min(most, in.random.between(cm(240), cm(420))), cm(60)));
  const int along_side = std::min(in.depth() - cm(60), in.random.between(cm(120), cm(240)));
  if (in.random.chance(70)) in.against(Wall::kAside, box(along_side, cm(60)));
  in.inCorner(Wall::kAny, box(cm(60), cm(65)));
  if (in.area() >= 9) in.standing(Wall::kAny, tableWithChairs(cm(in.random.oneOf({80, 120, 140})), cm(80), false));
  if (in.area() >= 20) in.standing(Wall::kBack, box(cm(180), cm(90)));
}

void bedroom(const Interior& in) {
  const bool parents = in.area() >= 12 && in.random.chance(65);
  const int width = cm(parents ? in.random.oneOf({140, 160, 180}) : 90);
  in.against(Wall::kOther, bed(width, in.random));
  in.inCorner(Wall::kAny, box(in.random.between(cm(120), cm(parents ? 280 : 180)), cm(60)));
  if (!parents) in.inCorner(Wall::kOther, desk(in.random));
  if (!parents && in.area() >= 16) in.inCorner(Wall::kOther, bed(cm(90), in.random));
  in.inCorner(Wall::kAny, box(cm(in.random.between(80, 140)), cm(45)));
  if (in.area() >= 18) in.inCorner(Wall::kAny, shelf(in.random, 80, 160));
}

void bath(const Interior& in) {
  in.inCorner(Wall::kBack, in.random.chance(50) ? box(cm(170), cm(75)) : box(cm(90), cm(90)));
  in.against(Wall::kAside, box(cm(60), cm(50)));
  in.against(Wall::kOther, box(cm(40), cm(60)));
  if (in.area() >= 6) in.inCorner(Wall::kAny, box(cm(60), cm(60)));
}

void study(const Interior& in) {
  in.against(Wall::kOther, desk(in.random));
  for (int i = 0; i < 2; ++i) in.inCorner(Wall::kAny, shelf(in.random, 80, 200));
  if (in.area() >= 12) in.inCorner(Wall::kOther, box(cm(200), cm(90)));
}

void office(const Interior& in) {
  const bool grouped = in.area() >= 16 && in.random.chance(60);
  if (grouped) in.against(Wall::kAside, box(cm(160), cm(45)));
  if (grouped) in.standing(Wall::kAny, deskGroup(in.random, in.area() / 22 + 1));
  const int desks = grouped ? 0 : std::max(1, in.area() / 8);
  for (int i = 0; i < desks; ++i) in.against(Wall::kOther, desk(in.random));
  for (int i = 0; i < 1 + in.area() / 12; ++i) {
    in.inCorner(Wall::kAny, box(cm(in.random.oneOf({80, 100, 120, 160})), cm(45)));
  }
}

void meeting(const Interior& in) {
  const bool along = in.length() >= in.depth();
  const Side wall = along ? in.front : in.left();
  const int most = (along ? in.length() : in.depth()) - cm(220);
  const int width = std::max(cm(120), std::min(most, cm(600)));
  const int across = cm(in.random.oneOf({100, 120}));
  const Furniture table = tableWithChairs(width, across, in.random.chance(40));
  const WallFrame frame = in.room.frame(wall);
  in.room.at(wall, {(frame.length() - table.width) / 2, (frame.depth() - table.depth) / 2}, table);
  in.inCorner(Wall::kOther, box(cm(120), cm(45)));
  in.inCorner(Wall::kOther, column(cm(40)));
}

void openPlan(const Interior& in) {
  const int desks = in.random.between(1, 3);
  const int pitch_x = desks * cm(160) + cm(in.random.oneOf({130, 160, 180}));
  const int pitch_y = cm(280) + cm(in.random.oneOf({70, 100, 120}));
  const int in_a_row = std::max(1, (in.length() - cm(60)) / pitch_x);
  const int rows = std::max(1, (in.depth() - cm(60)) / pitch_y);
  const int first_x = (in.length() - in_a_row * pitch_x) / 2 + (pitch_x - desks * cm(160)) / 2;
  const int first_y = (in.depth() - rows * pitch_y) / 2 + (pitch_y - cm(280)) / 2;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < in_a_row; ++i) {
      if (in.random.chance(10)) continue;
      in.room.at(in.front, {first_x + i * pitch_x, first_y + row * pitch_y}, deskGroup(in.random, desks));
    }
  }
  for (int i = 0; i < 2 + in.area() / 20; ++i) {
    in.against(Wall::kOther, box(cm(in.random.oneOf({80, 120, 160, 240})), cm(45)));
  }
}

void storage(const Interior& in) {
  const int depth = cm(in.random.oneOf({40, 50, 60}));
  for (const Side wall : {in.left(), opposite(in.left()), in.back()}) {
    const int most = in.room.frame(wall).length();
    in.room.inCorner(wall, box(most * in.random.between(55, 95) / 100, depth));
  }
  const Furniture island = box(in.depth() - cm(240), 2 * depth);
  if (in.depth() > cm(360)) {
    for (int i = 0; i < in.length() / cm(250); ++i) in.room.standing(in.left(), island);
  }
  in.against(Wall::kAny, box(cm(60), cm(80)));
}

void toilets(const Interior& in) {
  const bool back = in.length() >= in.depth();
  const Side wall = back ? in.back() : in.left();
  const int most = (in.room.frame(wall).length() - cm(10)) / cm(95);
  const int count = std::min(most, in.random.between(2, 5));
  if (count >= 1) in.room.inCorner(wall, cubicles(count));
  const Furniture basins = box(cm(in.random.oneOf({60, 120, 180})), cm(50));
  in.room.against(back ? in.aside() : opposite(wall), basins);
}

void patients(const Interior& in) {
  const Side heads = in.aside();
  const int beds = std::min(3, std::max(1, in.depth() / cm(240)));
  for (int i = 0; i < beds; ++i) in.room.against(heads, bed(cm(95), in.random));
  in.room.inCorner(in.random.chance(50) ? in.front : opposite(heads), box(cm(60 * beds), cm(60)));
  in.inCorner(Wall::kBack, tableWithChairs(cm(70), cm(70), false));
  if (in.random.chance(40)) in.room.against(opposite(heads), box(cm(90), cm(80)));
}

void nurseBase(const Interior& in) {
  const int width = std::max(cm(120), in.length() - cm(260));
  in.room.at(in.front, {(in.length() - width) / 2, cm(95)}, box(width, cm(60)));
  for (int i = 0; i < 2; ++i) in.against(Wall::kBack, desk(in.random));
  for (int i = 0; i < 2; ++i) in.inCorner(Wall::kAside, box(cm(120), cm(45)));
}

void examination(const Interior& in) {
  in.inCorner(Wall::kAside, box(cm(195), cm(70)));
  in.against(Wall::kOther, desk(in.random));
  for (int i = 0; i < 1 + in.area() / 10; ++i) in.inCorner(Wall::kAny, box(cm(in.random.between(60, 160)), cm(45)));
  if (in.area() >= 16) in.standing(Wall::kFront, box(cm(200), cm(80)));
}

void waiting(const Interior& in) {
  for (const Side wall : {in.back(), in.left(), opposite(in.left())}) {
    in.room.against(wall, chairs(std::max(2, (in.room.frame(wall).length() - cm(160)) / cm(55))));
  }
  in.standing(Wall::kFront, box(cm(80), cm(80)));
  in.inCorner(Wall::kOther, column(cm(45)));
}

}  // namespace

void furnish(Furnisher& room, PlanRandom& random, Side front, RoomUse use) {
  const Interior in{room, random, front};
  switch (use) {
    case RoomUse::kLiving:
      living(in);
      break;
    case RoomUse::kKitchen:
      kitchen(in);
      break;
    case RoomUse::kBedroom:
      bedroom(in);
      break;
    case RoomUse::kBath:
      bath(in);
      break;
    case RoomUse::kStudy:
      study(in);
      break;
    case RoomUse::kOffice:
      office(in);
      break;
    case RoomUse::kMeeting:
      meeting(in);
      break;
    case RoomUse::kOpenPlan:
      openPlan(in);
      break;
    case RoomUse::kStorage:
      storage(in);
      break;
    case RoomUse::kToilets:
      toilets(in);
      break;
    case RoomUse::kPatients:
      patients(in);
      break;
    case RoomUse::kNurseBase:
      nurseBase(in);
      break;
    case RoomUse::kExamination:
      examination(in);
      break;
    case RoomUse::kWaiting:
      waiting(in);
      break;
    case RoomUse::kEmpty:
      break;
  }
  room.finish();
}

}  // namespace frontier_pilot::bench
