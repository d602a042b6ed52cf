#include "fuzz/check_parameters.h"

#include "frontier_pilot/arbiter/parameters.h"
#include "frontier_pilot/avoid/parameters.h"
#include "frontier_pilot/behavior/parameters.h"
#include "frontier_pilot/core/robot_model.h"
#include "frontier_pilot/exploration/parameters.h"
#include "frontier_pilot/fleet/parameters.h"
#include "frontier_pilot/mapping/parameters.h"
#include "frontier_pilot/navigation/parameters.h"
#include "frontier_pilot/patrol/parameters.h"
#include "frontier_pilot/sim/parameters.h"
#include "teleop/parameters.h"
#include "waypoints/waypoint_follower.h"

namespace frontier_pilot::fuzz {

void loadAll(const ParameterMap& map) {
  load<arbiter::ArbiterParameters>(map);
  load<avoid::AvoiderParameters>(map);
  load<behavior::BehaviorParameters>(map);
  load<exploration::ExplorerParameters>(map);
  load<fleet::MapMergerParameters>(map);
  load<mapping::MapperParameters>(map);
  load<navigation::NavigatorParams>(map);
  load<patrol::PatrolParameters>(map);
  load<sim::SimulatorParameters>(map);
  load<teleop::TeleopParameters>(map);
  load<waypoints::WaypointParameters>(map);
}

}  // namespace frontier_pilot::fuzz
