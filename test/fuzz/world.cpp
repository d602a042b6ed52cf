// A world or a map of another program: a YAML, a line with %%, and the image, which the YAML may call image.pgm or
// image.png.

#include "fuzz/check_world.h"
#include "fuzz/scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own
  static const std::string kBorder = "\n%%\n";
  const std::string text = fuzz::textOf(data, size);
  const std::size_t border = text.find(kBorder);
  if (border == std::string::npos) return 0;
  const std::string image = text.substr(border + kBorder.size());
  fuzz::writeScratch("image.pgm", image);
  fuzz::writeScratch("image.png", image);
  fuzz::readWorld(fuzz::writeScratch("world.yaml", text.substr(0, border + 1)));
  return 0;
}
