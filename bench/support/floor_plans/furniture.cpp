#include "support/floor_plans/furniture.h"

#include <algorithm>

namespace frontier_pilot::bench {
namespace {

constexpr int kLeg = cm(5);
constexpr int kChair = cm(45);

/// The parts of `piece`, moved by (x, y).
void add(Furniture& to, const Furniture& piece, int x, int y) {
  for (const CellRect& part : piece.parts) to.parts.push_back({part.x + x, part.y + y, part.width, part.height});
}

/// The star-shaped foot of an office chair.
Furniture chairFoot() {
  const int side = cm(40);
  const int arm = cm(10);
  const int middle = (side - arm) / 2;
  return {side, side, {{middle, 0, arm, side}, {0, middle, side, arm}}};
}

Furniture diningChair() {
  Furniture chair = table(cm(40), cm(40));
  chair.parts.push_back({0, 0, cm(40), kLeg});
  return chair;
}

}  // namespace

Furniture box(int width, int depth) { return {width, depth, {{0, 0, width, depth}}}; }

Furniture table(int width, int depth) {
  const int right = width - kLeg;
  const int front = depth - kLeg;
  return {
      width, depth, {{0, 0, kLeg, kLeg}, {right, 0, kLeg, kLeg}, {0, front, kLeg, kLeg}, {right, front, kLeg, kLeg}}};
}

Furniture desk(PlanRandom& random) {
  const int width = cm(random.oneOf({140, 160, 160, 180}));
  const int depth = cm(80);
  Furniture desk = table(width, depth);
  const int pedestal = cm(40);
  const bool left = random.chance(50);
  if (random.chance(70)) desk.parts.push_back({left ? 0 : width - pedestal, cm(10), pedestal, cm(60)});
  const int chair = width / 2 - cm(20) + random.between(-2, 2);
  add(desk, chairFoot(), chair, depth + random.between(-2, 3));
  desk.depth = depth + cm(60);
  return desk;
}

Furniture deskGroup(PlanRandom& random, int desks_in_a_row) {
  const int width = cm(160);
  const int depth = cm(80);
  const int front = cm(60);
  Furniture group{desks_in_a_row * width, 2 * (depth + front), {}};
  for (int i = 0; i < desks_in_a_row; ++i) {
    for (const int row : {0, 1}) {
      add(group, table(width, depth), i * width, front + row * depth);
      if (random.chance(60)) group.parts.push_back({i * width + cm(5), front + row * depth + cm(10), cm(40), cm(60)});
      const int chair = row == 0 ? random.between(2, 5) : front + 2 * depth + random.between(0, 3) - 1;
      if (random.chance(85)) add(group, chairFoot(), i * width + cm(70) + random.between(-3, 3), chair);
    }
  }
  // A screen between the two rows.
  if (random.chance(50)) group.parts.push_back({0, front + depth - 1, group.width, 1});
  return group;
}

Furniture tableWithChairs(int width, int depth, bool solid) {
  Furniture group{width, depth + 2 * kChair, {}};
  add(group, solid ? box(width, depth) : table(width, depth), 0, kChair);
  const int pitch = cm(75);
  const int count = std::max(1, width / pitch);
  const int first = (width - (count - 1) * pitch - cm(40)) / 2;
  for (int i = 0; i < count; ++i) {
    add(group, diningChair(), first + i * pitch, 0);
    add(group, diningChair(), first + i * pitch, group.depth - cm(40));
  }
  return group;
}

Furniture bed(int width, PlanRandom& random) {
  const int table_side = cm(45);
  const bool both = width >= cm(140) && random.chance(60);
  Furniture bed{width + (both ? 2 : 1) * table_side, cm(205), {}};
  bed.parts.push_back({both ? table_side : 0, 0, width, bed.depth});
  bed.parts.push_back({bed.width - table_side, 0, table_side - 1, cm(40)});
  if (both) bed.parts.push_back({1, 0, table_side - 1, cm(40)});
  return bed;
}

Furniture sofa(PlanRandom& random) {
  const int width = cm(random.oneOf({180, 210, 240}));
  Furniture sofa = box(width, cm(90));
  const int gap = cm(45);
  const int low = cm(60);
  add(sofa, random.chance(50) ? box(cm(100), low) : table(cm(110), low), width / 2 - cm(50), sofa.depth + gap);
  sofa.depth += gap + low;
  return sofa;
}

Furniture chairs(int count) {
  const int pitch = cm(55);
  Furniture row{count * pitch, cm(50), {}};
  for (int i = 0; i < count; ++i) row.parts.push_back({i * pitch, 0, cm(50), cm(50)});
  return row;
}

Furniture cubicles(int count) {
  const int pitch = cm(95);
  const int depth = cm(150);
  Furniture row{count * pitch + 1, depth, {}};
  for (int i = 0; i <= count; ++i) row.parts.push_back({i * pitch, 0, 1, depth});
  for (int i = 0; i < count; ++i) {
    row.parts.push_back({i * pitch + cm(30), 0, cm(40), cm(60)});
    row.parts.push_back({i * pitch, depth - 1, cm(25), 1});
  }
  return row;
}

Furniture column(int diameter) {
  Furniture column{diameter, diameter, {}};
  for (int y = 0; y < diameter; ++y) {
    const int dy = 2 * y + 1 - diameter;
    int half = 0;
    while ((half + 1) * (half + 1) * 4 + dy * dy <= diameter * diameter) ++half;
    if (half > 0) column.parts.push_back({diameter / 2 - half, y, 2 * half + diameter % 2, 1});
  }
  return column;
}

Furniture machine(PlanRandom& random) {
  const int width = random.between(cm(120), cm(320));
  Furniture machine = box(width, random.between(cm(90), cm(180)));
  const int side = random.between(cm(40), cm(80));
  const int at = random.between(0, machine.width - side);
  machine.parts.push_back({at, machine.depth, side, side});
  machine.depth += side;
  if (random.chance(40)) {
    machine.parts.push_back({machine.width, cm(20), cm(60), cm(50)});
    machine.width += cm(60);
  }
  return machine;
}

}  // namespace frontier_pilot::bench
