// A log as CSV.

#include "logs/csv_log.h"

#include <sstream>

#include "fuzz/check_log.h"
#include "fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own
  std::istringstream file(fuzz::textOf(data, size));
  try {
    fuzz::checkLog(logs::readCsvLog(file, "log", {}));
  } catch (const logs::LogError&) {
  }
  return 0;
}
