// The image of a world, PGM or PNG.

#include "fuzz/check_world.h"
#include "fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own
  static const std::string kYaml = fuzz::writeScratch(
      "floor.yaml", "image: floor.pgm\nresolution: 0.05\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\nmode: scale\n");
  fuzz::writeScratch("floor.pgm", fuzz::textOf(data, size));
  fuzz::readWorld(kYaml);
  return 0;
}
