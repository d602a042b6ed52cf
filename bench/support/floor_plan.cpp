#include "support/floor_plan.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "frontier_pilot/grids/distance_field.h"
#include "sim/reachable_floor.h"
#include "support/floor_plans/building.h"

namespace frontier_pilot::bench {
namespace {

constexpr std::uint64_t kSeed = 0x466c6f6f72;  ///< changes all plans
constexpr double kRoomAtStart = 0.35;          ///< free floor around the start [m]

/// The least and greatest area of each kind of building [m^2].
struct Sizes {
  int least, most;
};
constexpr std::array<Sizes, 4> kSizes{{{100, 250}, {300, 1500}, {210, 2000}, {300, 1500}}};

/// Areas are drawn from five ranges, one for each plan of a kind in its half; small ones are more frequent.
int drawArea(BuildingKind kind, int stratum, PlanRandom& random) {
  const Sizes& sizes = kSizes[static_cast<std::size_t>(kind)];
  const int share = stratum * 200 + random.between(0, 199);  // [1/1000]
  return sizes.least + (sizes.most - sizes.least) * share / 1000 * share / 1000;
}

Building build(BuildingKind kind, int area, PlanRandom& random) {
  switch (kind) {
    case BuildingKind::kApartment:
      return apartment(area, random);
    case BuildingKind::kOffice:
      return officeFloor(area, random);
    case BuildingKind::kHall:
      return hall(area, random);
    case BuildingKind::kHospital:
      break;
  }
  return hospitalWing(area, random);
}

/// A plan turned and mirrored, so that not all buildings lie alike.
class Orientation {
 public:
  Orientation(const GridGeometry& from, PlanRandom& random) : from_(from) {
    transposed_ = random.chance(50);
    mirrored_x_ = random.chance(50);
    mirrored_y_ = random.chance(50);
    to_ = from;
    if (transposed_) std::swap(to_.width, to_.height);
  }
  Cell cell(Cell c) const {
    if (transposed_) std::swap(c.x, c.y);
    return {mirrored_x_ ? to_.width - 1 - c.x : c.x, mirrored_y_ ? to_.height - 1 - c.y : c.y};
  }
  CellRect rect(const CellRect& r) const {
    CellRect turned;
    turned.include(cell({r.x, r.y}));
    turned.include(cell({r.x + r.width - 1, r.y + r.height - 1}));
    return turned;
  }
  OccupancyGrid map(const OccupancyGrid& map) const {
    OccupancyGrid turned(to_);
    for (std::size_t i = 0; i < map.size(); ++i) turned[cell(from_.cell(i))] = map[i];
    return turned;
  }

 private:
  GridGeometry from_, to_;
  bool transposed_ = false, mirrored_x_ = false, mirrored_y_ = false;
};

/// A pose in one of the corridors, in one of the four directions of the walls. It is at a corner of a cell, so that the
/// cells of a robot's own map coincide with those of the plan: otherwise it would show a part of the floor as wall.
Pose2 drawStart(const OccupancyGrid& map, const std::vector<CellRect>& corridors, PlanRandom& random) {
  const grids::DistanceField clearance(sim::notFree(map), 2.0 * kRoomAtStart);
  std::vector<Cell> places;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const Cell cell = map.geometry().cell(i);
    const auto holds = [&](const CellRect& corridor) { return corridor.contains(cell); };
    if (clearance[cell] > kRoomAtStart && std::any_of(corridors.begin(), corridors.end(), holds)) {
      places.push_back(cell);
    }
  }
  if (places.empty()) throw std::logic_error("a floor plan without room for a start");
  const Cell cell = random.oneOf(places);
  return {Vec2(cell.x, cell.y) * map.resolution(), random.oneOf({0.0, 1.5708, 3.1416, -1.5708})};
}

}  // namespace

const char* toString(BuildingKind kind) {
  switch (kind) {
    case BuildingKind::kApartment:
      return "apartment";
    case BuildingKind::kOffice:
      return "office";
    case BuildingKind::kHall:
      return "hall";
    case BuildingKind::kHospital:
      break;
  }
  return "hospital";
}

FloorPlan floorPlan(int number) {
  if (number < 1 || number > kFloorPlans) throw std::invalid_argument("there is no such floor plan");
  PlanRandom random(kSeed + static_cast<std::uint64_t>(number));
  FloorPlan plan;
  plan.number = number;
  plan.kind = static_cast<BuildingKind>((number - 1) / 2 % 4);
  const Building building = build(plan.kind, drawArea(plan.kind, (number - 1) / 8, random), random);
  const PlanDraft& draft = building.draft();
  const OccupancyGrid map = draft.map();
  const Orientation orientation(map.geometry(), random);
  plan.map = orientation.map(map);
  const auto moved = [&](const std::vector<CellRect>& rects) {
    std::vector<CellRect> result;
    for (const CellRect& r : rects) {
      result.push_back(orientation.rect({r.x - draft.extent().x, r.y - draft.extent().y, r.width, r.height}));
    }
    return result;
  };
  plan.rooms = moved(draft.rooms());
  plan.start = drawStart(plan.map, moved(building.corridors()), random);
  return plan;
}

}  // namespace frontier_pilot::bench
