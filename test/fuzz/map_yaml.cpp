// The YAML of a saved map. The first line of the input is the map's name, the rest a YAML beside its octree.

#include "map_files/map_yaml.h"

#include <stdexcept>

#include "frontier_pilot/core/files.h"
#include "fuzz/fuzz.h"

namespace {

using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own

using map_files::SavedFile;

const std::string kOctree = "octree";
const std::string kPicture = "picture";
constexpr std::size_t kExtension = 5;  // .yaml

void checkName(const std::string& name) {
  if (!fileNameProblem(name, kExtension).empty()) return;
  const std::string yaml = map_files::mapYaml({0.05, {-1.0, 2.0}, 3, 4}, name, {kOctree, "previous"}, {kPicture, {}});
  fuzz::require(map_files::readsAs(yaml, name, kOctree, kPicture),
                "a map of any good name can be saved and read again");
  fuzz::require(map_files::compareWithYaml(yaml, SavedFile::kOctree, "previous") == map_files::FileMatch::kPrevious,
                "the octree that is replaced is recognised");
  fuzz::require(map_files::compareWithYaml(yaml, SavedFile::kPicture, "edited") == map_files::FileMatch::kAnother,
                "a picture that was edited is recognised");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  const std::size_t end = std::min(text.find('\n'), text.size());
  checkName(text.substr(0, end));
  try {
    const std::string yaml = text.substr(std::min(end + 1, text.size()));
    map_files::compareWithYaml(yaml, SavedFile::kOctree, kOctree);
    map_files::imageOf(yaml);
  } catch (const std::invalid_argument&) {
  }
  return 0;
}
