// Runs the examples of docs/api. Exit code 0 if all come out as they must; else those that did not are printed.
#include <cstdio>
#include <exception>
#include <functional>
#include <utility>
#include <vector>

#include "examples.h"
#include "support/temporary_folder.h"

namespace {

bool comesOut(const std::function<bool()>& example) {
  try {
    return example();
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return false;
  }
}

}  // namespace

int main() {
  const frontier_pilot::test::TemporaryFolder folder;
  const std::vector<std::pair<const char*, std::function<bool()>>> all = {
      {"arbiter", examples::arbiter},
      {"avoid", examples::avoid},
      {"behavior", examples::behavior},
      {"core", examples::core},
      {"exploration", examples::exploration},
      {"fleet", examples::fleet},
      {"grids", examples::grids},
      {"localization", examples::localization},
      {"logs", examples::logs},
      {"map_files", [&] { return examples::mapFiles(folder.path().string()); }},
      {"mapping", examples::mapping},
      {"navigation", examples::navigation},
      {"occupancy", examples::occupancy},
      {"patrol", examples::patrol},
      {"planning", examples::planning},
      {"scan_matching", examples::scanMatching},
      {"sim", examples::sim},
      {"slam", examples::slam},
      {"surfaces", examples::surfaces},
      {"system", examples::system},
  };
  int failed = 0;
  for (const auto& [name, example] : all) {
    if (comesOut(example)) continue;
    std::printf("failed: %s\n", name);
    ++failed;
  }
  return failed == 0 ? 0 : 1;
}
