#include "support/campus.h"

#include <algorithm>

#include "support/floor_plans/plan_random.h"

namespace frontier_pilot::bench {
namespace {

constexpr double kCell = 0.2;  // [m]
constexpr int kSide = 3000;    // [cells]: 600 m
constexpr int kPitch = 290;    // from plot to plot: 58 m
constexpr int kPlot = 240;     // side of a plot: 48 m; the streets are 10 m wide
constexpr int kFirst = 75;     // where the first plot begins
constexpr int kPlots = 10;     // in each direction
constexpr int kCorridor = 12;  // width of a corridor: 2.4 m
constexpr int kDoor = 8;       // 1.6 m

class Campus {
 public:
  explicit Campus(std::uint64_t seed) : random_(seed), map_(GridGeometry{kCell, Vec2::Zero(), kSide, kSide}, kFree) {}

  OccupancyGrid drawn() {
    frame({0, 0, kSide, kSide});
    for (int row = 0; row < kPlots; ++row) {
      for (int column = 0; column < kPlots; ++column) {
        plot({kFirst + column * kPitch, kFirst + row * kPitch, kPlot, kPlot});
      }
    }
    return std::move(map_);
  }

 private:
  void fill(const CellRect& cells, std::int8_t value) {
    const CellRect inside = cells.intersection(map_.geometry().rect());
    for (int y = inside.y; y < inside.y + inside.height; ++y) std::fill_n(map_.row(y) + inside.x, inside.width, value);
  }
  /// The walls around `cells`, one cell thick.
  void frame(const CellRect& cells) {
    fill({cells.x, cells.y, cells.width, 1}, kOccupied);
    fill({cells.x, cells.y + cells.height - 1, cells.width, 1}, kOccupied);
    fill({cells.x, cells.y, 1, cells.height}, kOccupied);
    fill({cells.x + cells.width - 1, cells.y, 1, cells.height}, kOccupied);
  }

  void plot(const CellRect& plot) {
    street(plot);
    const int kind = random_.between(1, 10);
    if (kind <= 4) return building(shrunk(plot), false);
    if (kind <= 6) return building(shrunk(plot), true);
    if (kind <= 8) return scatter(plot, 20, random_.between(1, 3));
    if (kind == 9) return carPark(plot);
    scatter(plot, 60, 2);
  }

  CellRect shrunk(const CellRect& plot) {
    const int x = random_.between(0, 30);
    const int y = random_.between(0, 30);
    return {plot.x + x, plot.y + y, plot.width - x - random_.between(0, 30), plot.height - y - random_.between(0, 30)};
  }

  /// Lamps and trees along the street south and west of a plot, unevenly spaced.
  void street(const CellRect& plot) {
    for (int at = 0; at < kPitch; at += random_.between(15, 35)) {
      const int trunk = random_.between(1, 3);
      fill({plot.x + at, plot.y - random_.between(8, 12), trunk, trunk}, kOccupied);
      fill({plot.x - random_.between(8, 12), plot.y + at, trunk, trunk}, kOccupied);
    }
  }

  /// Things of `size` cells or a little more, about `apart` cells from each other.
  void scatter(const CellRect& plot, int apart, int size) {
    for (int y = plot.y; y < plot.y + plot.height; y += apart) {
      for (int x = plot.x; x < plot.x + plot.width; x += apart) {
        const int grown = size + random_.between(0, 2);
        fill({x + random_.between(0, apart - 4), y + random_.between(0, apart - 4), grown, grown}, kOccupied);
      }
    }
  }

  /// Rows of cars of 4.4 m x 1.8 m; some places are free.
  void carPark(const CellRect& plot) {
    for (int y = plot.y + 15; y + 22 < plot.y + plot.height; y += 55) {
      for (int x = plot.x; x + 12 < plot.x + plot.width; x += 14) {
        if (random_.chance(60)) fill({x + random_.between(0, 2), y + random_.between(0, 4), 9, 22}, kOccupied);
      }
    }
  }

  /// Rooms on both sides of corridors that run from wall to wall, with a door at each end.
  void building(const CellRect& walls, bool has_courtyard) {
    frame(walls);
    const int wing = has_courtyard ? walls.height / 3 : walls.height / 2;
    for (int y = walls.y; y + wing <= walls.y + walls.height; y += has_courtyard ? walls.height - wing : wing) {
      rooms({walls.x, y, walls.width, wing});
    }
    if (!has_courtyard) return;
    const CellRect court{walls.x, walls.y + wing, walls.width, walls.height - 2 * wing};
    fill({court.x, court.y + court.height / 2, 1, kDoor}, kFree);
    fill({court.x + court.width - 1, court.y + court.height / 2, 1, kDoor}, kFree);
    scatter({court.x + 10, court.y + 10, court.width - 20, court.height - 20}, 30, 1);
  }

  void rooms(const CellRect& wing) {
    frame(wing);
    const int corridor = wing.y + (wing.height - kCorridor) / 2;
    for (const int y : {corridor, corridor + kCorridor - 1}) fill({wing.x, y, wing.width, 1}, kOccupied);
    for (const int x : {wing.x, wing.x + wing.width - 1}) fill({x, corridor + 2, 1, kDoor}, kFree);
    const int end = wing.x + wing.width - 20;
    for (int x = wing.x; x < end;) {
      const int next = std::min(x + random_.between(18, 45), end + 19);
      fill({next, wing.y, 1, corridor - wing.y}, kOccupied);
      fill({next, corridor + kCorridor, 1, wing.y + wing.height - corridor - kCorridor}, kOccupied);
      const int door = x + 2 + random_.between(0, std::max(0, next - x - kDoor - 3));
      fill({door, corridor, kDoor, 1}, kFree);
      fill({door, corridor + kCorridor - 1, kDoor, 1}, kFree);
      furnish({x, wing.y, next - x, corridor - wing.y});
      furnish({x, corridor + kCorridor, next - x, wing.y + wing.height - corridor - kCorridor});
      x = next;
    }
  }

  void furnish(const CellRect& room) {
    if (room.width < 14 || room.height < 14) return;
    const int depth = random_.between(3, 5);
    fill({room.x + 1, room.y + room.height - 1 - depth, random_.between(3, room.width / 2), depth}, kOccupied);
    fill({room.x + room.width / 2, room.y + room.height / 2, random_.between(1, 4), random_.between(1, 6)}, kOccupied);
  }

  PlanRandom random_;
  OccupancyGrid map_;
};

}  // namespace

sim::World campus(std::uint64_t seed) {
  // In the crossing at the south-western corner.
  const double crossing = kCell * (kFirst - 25);
  return {Campus(seed).drawn(), Pose2(crossing, crossing, 0.0)};
}

}  // namespace frontier_pilot::bench
