#include "examples.h"

#include "frontier_pilot/system/closed_loop.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::system() {
  //! [example]
  fp::system::ClosedLoop loop({roomMap(), fp::Pose2(-1.5, -0.5, 0.0)}, {});
  while (!loop.done() && fp::toSeconds(loop.now()) < 600.0) loop.step();
  const fp::OccupancyGrid& map = loop.mapper().grid();  // in a frame that begins where the robot does
  const bool mapped = fp::isFree(map[map.geometry().cellAt({3.02, 1.02})]);
  return loop.done() && mapped && loop.simulator().contactCount(0) == 0;
  //! [example]
}
