#include "frontier_pilot/fleet/map_merger.h"

#include "fleet/clear_space.h"

namespace frontier_pilot::fleet {
namespace {

constexpr std::size_t kMostCompared = 1'000'000;  ///< cells of a map; of larger ones every n-th is compared
constexpr std::size_t kFewWalls = 200;            ///< [cells], 10 m of a wall in cells of 5 cm

double share(std::size_t part, std::size_t whole) { return static_cast<double>(part) / static_cast<double>(whole); }

}  // namespace

double Agreement::agreeingShare() const { return known == 0 ? 1.0 : share(agreeing, known); }

double Agreement::contradictedShare() const { return walls < kFewWalls ? 0.0 : share(contradicted, walls); }

Agreement& Agreement::operator+=(const Agreement& other) {
  overlap += other.overlap;
  known += other.known;
  agreeing += other.agreeing;
  walls += other.walls;
  contradicted += other.contradicted;
  return *this;
}

Agreement compare(const OccupancyGrid& a, const OccupancyGrid& b, const Pose2& T_a_b) {
  Agreement result;
  const Rotation2 rotation(T_a_b.yaw);
  // An odd step, so that it does not meet the same columns again and again.
  const std::size_t step = b.size() <= kMostCompared ? 1 : (b.size() / kMostCompared) | 1U;
  for (std::size_t i = 0; i < b.size(); i += step) {
    const std::int8_t in_b = b[i];
    if (isUnknown(in_b)) continue;
    const Cell cell = b.geometry().cell(i);
    const Cell other = a.geometry().cellAt(rotation.applied(b.geometry().centre(cell), T_a_b.position()));
    const std::int8_t in_a = a.get(other, kUnknown);
    if (isUnknown(in_a)) continue;
    ++result.known;
    if (isOccupied(in_a) == isOccupied(in_b)) ++result.agreeing;
    if (isOccupied(in_a)) {
      ++result.walls;
      if (isClearAround(b, cell)) ++result.contradicted;
    }
    if (isOccupied(in_b)) {
      ++result.walls;
      if (isClearAround(a, other)) ++result.contradicted;
    }
  }
  for (std::size_t* count : {&result.known, &result.agreeing, &result.walls, &result.contradicted}) *count *= step;
  result.overlap = static_cast<double>(result.known) * square(b.resolution());
  return result;
}

}  // namespace frontier_pilot::fleet
