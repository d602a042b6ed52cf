#include "support/closed_loop/corridor_world.h"

namespace frontier_pilot::test {
namespace {

/// Rectangles of floor, and things in them, on a grid of 5 cm.
class Plan {
 public:
  Plan(double width, double height)
      : map_(GridGeometry{0.05, Vec2::Zero(), static_cast<int>(width / 0.05), static_cast<int>(height / 0.05)},
             kOccupied) {}
  void fill(const Vec2& low, const Vec2& high, std::int8_t value) {
    for (std::size_t i = 0; i < map_.size(); ++i) {
      const Vec2 centre = map_.geometry().centre(map_.geometry().cell(i));
      if ((centre - low).minCoeff() > 0.0 && (high - centre).minCoeff() > 0.0) map_[i] = value;
    }
  }
  const OccupancyGrid& map() const { return map_; }

 private:
  OccupancyGrid map_;
};

}  // namespace

sim::World corridorWorld() {
  Plan plan(43.0, 7.0);
  plan.fill({0.5, 0.5}, {4.5, 6.0}, kFree);
  plan.fill({37.5, 1.0}, {42.5, 6.5}, kFree);
  plan.fill({4.5, 2.5}, {37.5, 4.3}, kFree);
  plan.fill({1.0, 5.0}, {2.2, 6.0}, kOccupied);
  plan.fill({2.6, 0.5}, {3.0, 0.9}, kOccupied);
  plan.fill({40.0, 1.0}, {42.5, 1.6}, kOccupied);
  plan.fill({41.0, 4.0}, {41.4, 4.4}, kOccupied);
  return {plan.map(), Pose2(2.0, 3.4, 0.0)};
}

}  // namespace frontier_pilot::test
