// What the process that reads a rosbag sends to map_log. A process with a damaged memory may send anything.

#include "ros/map_log/packed_log.h"

#include <stdexcept>

#include "fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own
  const std::string bytes = fuzz::textOf(data, size);
  try {
    const logs::ScanLog log = unpackLog(bytes);
    fuzz::require(!log.records.empty(), "a log that is accepted holds a scan");
    fuzz::require(packLog(log) == bytes, "a log that is accepted is the one that was sent");
  } catch (const std::length_error&) {
  }
  return 0;
}
