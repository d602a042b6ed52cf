#include "examples.h"

#include "frontier_pilot/sim/simulator.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::sim() {
  //! [example]
  fp::sim::Simulator simulator({roomMap(), fp::Pose2()}, {});
  int scans = 0;
  while (fp::toSeconds(simulator.now()) < 2.0) {
    simulator.setCommand(0, {0.2, 0.0});
    simulator.step();
    if (simulator.newScan(0) != nullptr) ++scans;  // ten in a second
  }
  return simulator.pose(0).x > 0.35 && scans >= 19 && simulator.contactCount(0) == 0;
  //! [example]
}
