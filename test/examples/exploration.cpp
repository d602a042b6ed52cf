#include "examples.h"

#include "frontier_pilot/exploration/explorer.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::exploration() {
  //! [example]
  fp::OccupancyGrid map = roomMap();
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (map.geometry().centre(map.geometry().cell(i)).x() > 1.0) map[i] = fp::kUnknown;
  }
  fp::exploration::Explorer explorer;
  explorer.setMap(map, map.geometry().rect());
  const fp::Time now = fp::timeFromSeconds(10.0);
  fp::exploration::ExplorerInputs inputs;
  inputs.T_map_base = fp::StampedPose2{now, fp::Pose2(-2.0, 0.0, 0.0)};
  inputs.odometry_stamp = now;
  const fp::exploration::GoalCommand command = explorer.update(inputs, now).command;  // for the navigation
  return command.kind == fp::exploration::GoalCommand::Kind::kSend && command.goal.x > -2.0;
  //! [example]
}
