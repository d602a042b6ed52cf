#include "frontier_pilot/avoid/parameters.h"

namespace frontier_pilot {

double Sector::width() const {
  const double turn = normalizeAngle(to - from);
  return turn < 0.0 ? turn + 2.0 * kPi : turn;
}

void AvoiderParameters::check(Problems& problems) const {
  const auto checkSector = [&](const char* name, const Sector& sector) {
    if (sector.width() <= 0.0 || sector.width() >= kPi) {
      problems.push_back(std::string(name) + ": must be wider than nothing and narrower than half a turn");
    }
  };
  checkSector("front_left", front_left);
  checkSector("front_right", front_right);
  checkSector("rear", rear);
  if (clear_distance <= stop_distance) problems.emplace_back("clear_distance: must be greater than stop_distance");
}

}  // namespace frontier_pilot
