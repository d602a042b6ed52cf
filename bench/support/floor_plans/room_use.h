#pragma once

#include "support/floor_plans/furnisher.h"

namespace frontier_pilot::bench {

/// What a room is for, which decides upon its furniture.
enum class RoomUse {
  kLiving,
  kKitchen,
  kBedroom,
  kBath,
  kStudy,
  kOffice,
  kMeeting,
  kOpenPlan,
  kStorage,
  kToilets,
  kPatients,
  kNurseBase,
  kExamination,
  kWaiting,
  kEmpty,
};

/// Furnishes a room whose door, or open side, is at `front`.
void furnish(Furnisher& room, PlanRandom& random, Side front, RoomUse use);

}  // namespace frontier_pilot::bench
