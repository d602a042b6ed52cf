#include "frontier_pilot/avoid/avoider.h"

namespace frontier_pilot::avoid {

const char* toString(AvoiderState state) {
  constexpr const char* kNames[] = {"idle", "waiting", "clear", "reverse", "rotate", "fault", "stuck"};
  return kNames[static_cast<int>(state)];
}

}  // namespace frontier_pilot::avoid
