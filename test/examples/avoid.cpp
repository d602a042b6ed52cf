#include "examples.h"

#include "frontier_pilot/avoid/avoider.h"
#include "room.h"

namespace fp = frontier_pilot;

bool examples::avoid() {
  //! [example]
  fp::avoid::Avoider avoider{fp::avoid::AvoiderParameters()};
  const fp::Time now = fp::timeFromSeconds(10.0);
  const fp::LaserScan2 scan = scanFrom(fp::Pose2(2.7, 0.0, 0.0), now);  // there is a wall 0.3 m ahead
  const auto command = avoider.onScan(scan, now);                       // to be published at once, if there is one
  const bool backs_up = command && command->twist.linear < 0.0;
  return backs_up && avoider.state() == fp::avoid::AvoiderState::kReverse;
  //! [example]
}
