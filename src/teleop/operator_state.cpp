#include "teleop/operator_state.h"

#include <algorithm>

namespace frontier_pilot::teleop {

std::string ArbiterView::driver() const {
  if (active_source.empty()) return "nobody drives";
  return active_source + (command.isZero() ? " holds the robot still" : " drives");
}

const SourceView* OperatorState::source(const std::string& name) const {
  if (!arbiter) return nullptr;
  const auto found = std::find_if(arbiter->sources.begin(), arbiter->sources.end(),
                                  [&name](const SourceView& source) { return source.name == name; });
  return found == arbiter->sources.end() ? nullptr : &*found;
}

}  // namespace frontier_pilot::teleop
