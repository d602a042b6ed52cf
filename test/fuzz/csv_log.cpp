// A log as CSV.

#include "logs/csv_log.h"

#include "fuzz/check_log.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own
  fuzz::readLog(data, size, [](std::istream& file) { return logs::readCsvLog(file, "log", {}); });
  return 0;
}
