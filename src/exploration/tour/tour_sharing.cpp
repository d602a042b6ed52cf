#include "exploration/tour/tour_strategy.h"

namespace frontier_pilot::exploration {

/// Leaves the frontiers to others that these see sooner than the tour would, until nothing on the tour is left to them.
/// A tour without them gets to the others of its frontiers sooner, and to small ones if no others are left to it.
/// [MUL-2]
void TourStrategy::leaveToOthers(SharedWork& shared) {
  for (bool left_any = true; left_any;) {
    left_any = false;
    for (const Stop& stop : plan(std::nullopt).stops) {
      for (const std::size_t frontier : stop.frontiers) {
        if (!shared.leaves(evaluator_->frontiers()[frontier].anchor, stop.arrival, evaluator_->map())) continue;
        left_[frontier] = left_any = true;
        evaluator_->reject(frontier, Rejection::kClaimed);
      }
    }
    if (left_any) putOffSmallOnes();
  }
}

}  // namespace frontier_pilot::exploration
