// A YAML text: parameters, the description of a world or of a saved map.

#include <stdexcept>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/files.h"
#include "frontier_pilot/core/parameters.h"
#include "fuzz/fuzz.h"

namespace {

using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own

/// The number of values in `map`, of which none may be too deep.
int count(const ParameterMap& map, int depth);

int count(const ParameterValue& value, int depth) {
  fuzz::require(depth <= bounds::kMostYamlDepth, "values are nested at most 32 deep");
  if (const auto* map = std::get_if<ParameterMap>(&value.value)) return 1 + count(*map, depth + 1);
  int values = 1;
  if (const auto* list = std::get_if<ParameterList>(&value.value)) {
    for (const ParameterValue& item : *list) values += count(item, depth + 1);
  }
  return values;
}

int count(const ParameterMap& map, int depth) {
  int values = 0;
  for (const auto& [key, value] : map) values += count(value, depth);
  return values;
}

/// A text that `yamlText` has written is read as it was, if it is one that may be a file's name.
void checkQuoting(const std::string& text) {
  if (!fileNameProblem(text, 0).empty()) return;
  const ParameterMap map = parseYaml("key: " + yamlText(text) + "\n");
  const auto entry = map.find("key");
  const auto* read = entry == map.end() ? nullptr : std::get_if<std::string>(&entry->second.value);
  fuzz::require(read != nullptr && *read == text, "yamlText writes what parseYaml reads");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  try {
    fuzz::require(count(parseYaml(text), 1) <= bounds::kMostYamlValues, "there are at most 100000 values");
  } catch (const std::invalid_argument&) {
  }
  checkQuoting(text);
  return 0;
}
