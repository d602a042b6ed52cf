#pragma once

#include <vector>

#include "support/floor_plans/plan_random.h"
#include "support/floor_plans/wall_frame.h"

namespace frontier_pilot::bench {

/// A piece of furniture, or a group that belongs together, as the scanner sees it: solid parts within a block of width
/// by depth, whose side y = 0 is its back.
struct Furniture {
  int width = 0;
  int depth = 0;
  std::vector<CellRect> parts;
};

Furniture box(int width, int depth);
/// Four legs.
Furniture table(int width, int depth);
/// Legs, a pedestal under one end, and the foot of a chair in front.
Furniture desk(PlanRandom& random);
/// Two rows of desks back to back, with chairs on both sides.
Furniture deskGroup(PlanRandom& random, int desks_in_a_row);
/// A table, on legs or solid, with chairs on both long sides.
Furniture tableWithChairs(int width, int depth, bool solid);
/// A bed, with its head at the back, and a night table on one or both sides.
Furniture bed(int width, PlanRandom& random);
/// A sofa and the table in front of it.
Furniture sofa(PlanRandom& random);
/// Chairs side by side.
Furniture chairs(int count);
/// Cubicles of a toilet, side by side; they are open in front.
Furniture cubicles(int count);
/// A round column.
Furniture column(int diameter);
/// Machines, or stacked goods: a large block with smaller ones attached.
Furniture machine(PlanRandom& random);

}  // namespace frontier_pilot::bench
