// The relations between poses that map_log compares a trajectory with.

#include <sstream>

#include "frontier_pilot/logs/scan_log.h"
#include "frontier_pilot/logs/trajectory.h"
#include "fuzz/check_log.h"
#include "fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own
  const std::vector<Pose2> poses{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.5}, {1.0, 1.0, 3.0}};
  std::istringstream file(fuzz::textOf(data, size));
  try {
    const auto relations = logs::readRelations(file, "relations", poses.size());
    const logs::RelationError error = logs::relationError(poses, relations);
    for (const double value : {error.translation.mean, error.translation.stddev, error.rotation.mean})
      fuzz::require(std::isfinite(value), "the errors are finite");
  } catch (const logs::LogError&) {
  }
  return 0;
}
