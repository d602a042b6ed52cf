#include "examples.h"

#include "frontier_pilot/arbiter/arbiter.h"

namespace fp = frontier_pilot;

bool examples::arbiter() {
  //! [example]
  fp::arbiter::Arbiter arbiter{fp::arbiter::ArbiterParameters()};
  const fp::Instant now{fp::timeFromSeconds(10.0), fp::timeFromSeconds<fp::SteadyTime>(10.0)};
  const auto first = arbiter.onCommand(*arbiter.find("nav"), {0.2, 0.0}, now);       // to be published at once
  const auto second = arbiter.onCommand(*arbiter.find("manual"), {-0.1, 0.0}, now);  // nothing: `nav` ranks higher
  const bool nav_drives = first && first->linear == 0.2 && !second && arbiter.status(now).active_source == "nav";
  const fp::arbiter::ArbiterAnswer answer = arbiter.stop("the operator", now);  // `answer.publish` is the zero
  const bool stands = arbiter.stopped() && answer.publish && answer.publish->isZero();
  return nav_drives && stands && arbiter.status(now).stop_cause == "the operator";
  //! [example]
}
