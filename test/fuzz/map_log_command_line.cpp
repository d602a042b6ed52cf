// The command line of map_log, a word in each line, and the values that the benchmarks' options take.

#include <cmath>
#include <stdexcept>

#include "frontier_pilot/core/bounds.h"
#include "fuzz/fuzz.h"
#include "tools/arguments.h"
#include "tools/map_log_options.h"

namespace {

using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own

void checkOptions(const tools::MapLogOptions& options) {
  fuzz::require(!options.log.empty() && !options.out.empty(), "there is a log and a place for the map");
  const double resolution = options.mapper.map.resolution;
  fuzz::require(resolution >= bounds::kLeastResolution && resolution <= bounds::kMostResolution, "cells have a size");
  const logs::LogScanner& scanner = options.scanner;
  fuzz::require(scanner.range_max.value_or(1.0) > 0.0, "the range is positive");
  const double field_of_view = scanner.field_of_view.value_or(1.0);
  fuzz::require(field_of_view > 0.0 && field_of_view < 6.3, "the field of view is at most a turn");
  const Pose2 mount = scanner.T_base_sensor.value_or(Pose2());
  fuzz::require(std::isfinite(mount.yaw) && mount.position().norm() <= bounds::kMostMount,
                "the scanner is on the robot");
}

/// Reads the words as what --seeds of a benchmark takes.
void readRanges(const std::vector<std::string>& words) {
  tools::Arguments arguments(words);
  while (!arguments.atEnd()) fuzz::require(arguments.range().size() <= 100'000, "a range is not endless");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string> words = fuzz::wordsOf(data, size);
  try {
    checkOptions(tools::parseMapLogOptions(words));
  } catch (const std::invalid_argument&) {
  }
  try {
    readRanges(words);
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
