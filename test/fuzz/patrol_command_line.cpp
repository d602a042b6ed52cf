// The command line of patrol_client, a word in each line, and what the server makes of the order.

#include "frontier_pilot/patrol/command_line.h"

#include "fuzz/fuzz.h"
#include "patrol/plan.h"

namespace {

using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own

void checkOrder(const patrol::PatrolOrder& order) {
  const patrol::PatrolParameters parameters;
  if (const auto problem = problemOf(order, parameters))
    return fuzz::require(!problem->empty(), "a refusal has a reason");
  const std::vector<patrol::PatrolStep> steps = patrol::planPatrol(order);
  fuzz::require(!steps.empty() && patrol::legsOf(order) >= 1, "an order that is accepted can be driven");
  patrol::Patrol patrol(parameters);
  fuzz::require(patrol.start(order, Time()).outcome == patrol::PatrolOutcome::kRunning, "and is driven");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const patrol::PatrolCommandLine line = patrol::parsePatrolCommandLine(fuzz::wordsOf(data, size));
  const int answers = (line.goal ? 1 : 0) + (line.help ? 1 : 0) + (line.problem.empty() ? 0 : 1);
  fuzz::require(answers == 1, "a command line is an order, a question or wrong");
  if (line.goal) checkOrder(*line.goal);
  return 0;
}
