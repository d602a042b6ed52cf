#include "frontier_pilot/avoid/parameters.h"

namespace frontier_pilot::avoid {
namespace {

constexpr double kStopMargin = 0.395;      // [m], ahead of the front
constexpr double kClearMargin = 0.15;      // [m], beyond the stop distance
constexpr double kRearStopMargin = 0.145;  // [m], behind the rear

double orElse(double configured, double needed) { return configured > 0.0 ? configured : needed; }

}  // namespace

double Sector::width() const {
  const double turn = normalizeAngle(to - from);
  return turn < 0.0 ? turn + 2.0 * kPi : turn;
}

void AvoiderParameters::check(Problems& problems) const {
  const auto checkSector = [&](const char* name, const Sector& sector) {
    if (sector.width() <= 0.0 || sector.width() >= kPi) {
      problems.push_back(std::string(name) + ": must be wider than 0 and narrower than half a turn");
    }
  };
  checkSector("front_left", front_left);
  checkSector("front_right", front_right);
  checkSector("rear", rear);
  Problems of_the_robot;
  robot.check(of_the_robot);
  if (!of_the_robot.empty()) return;  // reported elsewhere, and such a robot has no valid outline
  const AvoiderDistances distances(*this);
  if (distances.stop <= robot.drivenOutline().front()) {
    problems.emplace_back("stop_distance: must be beyond the robot's front");
  }
  if (distances.clear <= distances.stop) problems.emplace_back("clear_distance: must be greater than stop_distance");
}

AvoiderDistances::AvoiderDistances(const AvoiderParameters& parameters) {
  const Outline outline = parameters.robot.drivenOutline();
  stop = orElse(parameters.stop_distance, outline.front() + kStopMargin);
  clear = orElse(parameters.clear_distance, stop + kClearMargin);
  rear_stop = orElse(parameters.rear_stop_distance, outline.rear() + kRearStopMargin);
  half_lane = outline.halfWidth() + parameters.guard_margin;
  turn = outline.isDisc() ? 0.0 : outline.circumscribedRadius() + parameters.guard_margin;
}

}  // namespace frontier_pilot::avoid
