// The parameters of all modules, in a YAML file.

#include <stdexcept>

#include "fuzz/check_parameters.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own
  try {
    fuzz::loadAll(parseYaml(fuzz::textOf(data, size)));
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
