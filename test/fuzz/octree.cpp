// A .bt file, read into a map that holds something already.

#include <sstream>

#include "frontier_pilot/occupancy/occupancy_map.h"
#include "fuzz/fuzz.h"

namespace {

using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own
using occupancy::OccupancyMap;

/// As small as parameters allow, so that a leaf of a large cube fills it soon.
occupancy::OccupancyMapParameters smallest() {
  occupancy::OccupancyMapParameters parameters;
  parameters.max_memory = 1.0;
  return parameters;
}

OccupancyMap mapWithThreeCells() {
  OccupancyMap map(smallest());
  map.reserve({-1.0, -1.0}, {1.0, 1.0});
  map.beginScan();
  map.hit({25, 25});
  map.miss({26, 25});
  map.miss({27, 25});
  return map;
}

std::string bytesOf(const OccupancyMap& map) {
  std::ostringstream out;
  fuzz::require(map.write(out), "a map can be written");
  return out.str();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  OccupancyMap map = mapWithThreeCells();
  const std::string before = bytesOf(map);
  const GridGeometry geometry = map.geometry();
  std::string why;
  if (!map.read(text, why)) {
    fuzz::require(!why.empty(), "a refusal has a reason");
    fuzz::require(bytesOf(map) == before && map.geometry() == geometry, "a refusal changes nothing");
    return 0;
  }
  fuzz::require(!map.isBlank(), "a map that was read is not empty");
  fuzz::require(map.memory() < 4'000'000, "a map takes no more memory than it may");
  const std::string after = bytesOf(map);
  OccupancyMap again(smallest());
  fuzz::require(again.read(after, why), "what was read can be written and read again");
  fuzz::require(bytesOf(again) == after, "and is the same then");
  return 0;
}
