#pragma once

#include <optional>
#include <vector>

#include "support/floor_plans/furniture.h"
#include "support/floor_plans/plan_draft.h"

namespace frontier_pilot::bench {

/// Puts furniture into one room so that a person can walk between the pieces: each stands against something, or at
/// least 0.6 m away from it.
class Furnisher {
 public:
  /// `entrance`: a cell inside of the room's door.
  Furnisher(PlanDraft& draft, PlanRandom& random, const CellRect& room, Cell entrance)
      : draft_(draft), random_(random), room_(room), entrance_(entrance) {}

  /// With its back against this wall of the room, at a random place. False if no place was found.
  bool against(Side wall, const Furniture& piece);
  /// The same at one of the wall's ends.
  bool inCorner(Side wall, const Furniture& piece);
  /// Free-standing, with its back towards `wall`.
  bool standing(Side wall, const Furniture& piece);
  /// At this place of the frame of `wall`.
  bool at(Side wall, Cell place, const Furniture& piece);

  /// Takes out the last pieces again until the room's floor can be walked.
  void finish();

  const CellRect& room() const { return room_; }
  /// The floor's length along `wall` and away from it [cells].
  WallFrame frame(Side wall) const { return {room_, wall}; }

 private:
  bool tryNear(Side wall, Cell place, const Furniture& piece);
  bool fits(const CellRect& block) const;
  bool keepsDistance(const CellRect& block, Side side) const;
  bool isWalkable() const;

  PlanDraft& draft_;
  PlanRandom& random_;
  CellRect room_;
  Cell entrance_;
  std::vector<CellRect> placed_;
};

}  // namespace frontier_pilot::bench
