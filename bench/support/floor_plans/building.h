#pragma once

#include <vector>

#include "support/floor_plans/plan_draft.h"
#include "support/floor_plans/plan_random.h"
#include "support/floor_plans/room_use.h"

namespace frontier_pilot::bench {

/// A kind of room in a row of them.
struct RoomKind {
  RoomUse use = RoomUse::kEmpty;
  int weight = 1;           ///< how often it occurs, relative to the others
  int least = 0, most = 0;  ///< width along the corridor [cells]
  bool open = false;        ///< to the corridor, without a wall
};
using RoomKinds = std::vector<RoomKind>;

/// A building under construction: corridors are carved first, rooms follow beside them. Walls between rooms all have
/// the same thickness.
class Building {
 public:
  /// Inner walls are `wall` cells thick.
  Building(int width, int height, int wall, PlanRandom& random) : draft_(width, height), random_(random), wall_(wall) {}

  /// Floor on which a robot may start.
  void corridor(const CellRect& area);
  /// A furnished room with a door to the corridor at its side `front`, or open to it.
  void room(const CellRect& area, Side front, RoomUse use, bool open = false);
  /// Rooms side by side over all of `area`, drawn from `kinds`, with a corridor along the side `front`.
  void row(const CellRect& area, Side front, const RoomKinds& kinds);

  /// The same in steps, for rooms with several doors: the room's floor; its doors, of which each returns a cell inside
  /// of the room; and its furniture, which leaves a way from the cell `entrance` to the rest.
  void shell(const CellRect& area) { draft_.addRoom(area); }
  Cell door(const CellRect& area, Side side, int width);
  Cell doorBetween(const CellRect& area, Side side, int width, int low, int high);
  Cell opening(const CellRect& area, Side side, int low, int high);
  void furnish(const CellRect& area, Side front, RoomUse use, Cell entrance);

  PlanDraft& draft() { return draft_; }
  const PlanDraft& draft() const { return draft_; }
  int wall() const { return wall_; }
  const std::vector<CellRect>& corridors() const { return corridors_; }

 private:
  RoomKind draw(const RoomKinds& kinds, int most);
  Cell patientsDoor(const CellRect& area, Side front);

  PlanDraft draft_;
  PlanRandom& random_;
  int wall_;
  std::vector<CellRect> corridors_;
};

/// The kinds of buildings, each with about `area` [m^2] between its outer walls.
Building apartment(int area, PlanRandom& random);
Building officeFloor(int area, PlanRandom& random);
Building hall(int area, PlanRandom& random);
Building hospitalWing(int area, PlanRandom& random);

/// The width [cells] of a rectangle of `area` [m^2] with this height [cells].
constexpr int widthFor(int area, int height) { return area * 400 / height; }

}  // namespace frontier_pilot::bench
