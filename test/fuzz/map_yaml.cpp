// The YAML of a saved map. The first line of the input is the map's name, the rest a YAML beside its octree.

#include "map_files/map_yaml.h"

#include <stdexcept>

#include "frontier_pilot/core/files.h"
#include "fuzz/fuzz.h"

namespace {

using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own

constexpr const char* kOctree = "octree";
constexpr std::size_t kExtension = 5;  // .yaml

void checkName(const std::string& name) {
  if (!fileNameProblem(name, kExtension).empty()) return;
  const std::string yaml = map_files::mapYaml({0.05, {-1.0, 2.0}, 3, 4}, name, kOctree, std::string("previous"));
  fuzz::require(map_files::readsAs(yaml, name, kOctree), "a map of any good name can be saved and read again");
  fuzz::require(map_files::compareOctree(yaml, "previous") == map_files::OctreeMatch::kPrevious,
                "the octree that is replaced is recognised");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  const std::size_t end = std::min(text.find('\n'), text.size());
  checkName(text.substr(0, end));
  try {
    map_files::compareOctree(text.substr(std::min(end + 1, text.size())), kOctree);
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
