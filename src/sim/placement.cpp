#include "frontier_pilot/sim/simulator.h"

namespace frontier_pilot::sim {

const char* toString(Placement placement) {
  switch (placement) {
    case Placement::kDone:
      return "done";
    case Placement::kUnknownRobot:
      return "there is no robot of that name";
    case Placement::kUnknownObstacle:
      return "there is no obstacle of that name";
    case Placement::kNameTaken:
      return "there is an obstacle of that name already";
    case Placement::kBadRadius:
      return "the radius must be positive";
    case Placement::kTooLarge:
      return "the radius must be at most 10 m: draw larger things into the world";
    case Placement::kTooFar:
      return "the place is farther than 1000 km from the origin";
    case Placement::kTooMany:
      return "there are 1000 obstacles already";
    case Placement::kNameTooLong:
      return "the name must have at most 256 characters";
    case Placement::kNotFinite:
      return "the pose is not finite";
    case Placement::kOutside:
      return "the place is outside of the world";
    case Placement::kInWall:
      return "the place is in or too near to a wall";
    case Placement::kOnRobot:
      return "the place is taken by a robot";
    case Placement::kOnObstacle:
      return "the place is taken by an obstacle";
  }
  return "?";
}

}  // namespace frontier_pilot::sim
