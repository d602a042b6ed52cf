#include <yaml-cpp/yaml.h>

#include <stdexcept>
#include <vector>

#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/files.h"
#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/text.h"

namespace frontier_pilot {
namespace {

ParameterValue scalar(const YAML::Node& node) {
  // A quoted scalar carries the tag "!": it is a string, whatever it looks like.
  if (node.Tag() == "!") return {node.Scalar()};
  bool flag = false;
  std::int64_t integer = 0;
  double real = 0.0;
  if (YAML::convert<std::int64_t>::decode(node, integer)) return {integer};
  if (YAML::convert<double>::decode(node, real)) return {real};
  if (YAML::convert<bool>::decode(node, flag)) return {flag};
  return {node.Scalar()};
}

/// Copies the parser's tree, with a limit on its depth and on its number of values. Aliases make a graph of it: a few
/// lines can form a cycle or expand to more values than fit into memory. [FLT-1]
class Copy {
 public:
  ParameterMap map(const YAML::Node& node) {
    ParameterMap map;
    for (const auto& entry : node) {
      if (!entry.first.IsScalar())
        throw std::invalid_argument("a key is a list, a dictionary or empty, and not a word");
      if (!map.emplace(entry.first.Scalar(), value(entry.second)).second)
        throw std::invalid_argument("the key '" + entry.first.Scalar() + "' is there twice");
    }
    return map;
  }

 private:
  ParameterValue value(const YAML::Node& node) {
    if (depth_ >= bounds::kMostYamlDepth) throw std::invalid_argument("values are nested more than 32 deep");
    if (++values_ > bounds::kMostYamlValues) throw std::invalid_argument("more than 100000 values");
    ++depth_;
    ParameterValue copy = inner(node);
    --depth_;
    return copy;
  }
  ParameterValue inner(const YAML::Node& node) {
    if (node.IsMap()) return {map(node)};
    if (node.IsScalar()) return scalar(node);
    if (!node.IsSequence()) return {};
    ParameterList list;
    for (const auto& item : node) list.push_back(value(item));
    return {list};
  }

  int depth_ = 0;
  int values_ = 0;
};

ParameterMap rootMap(const std::string& text) {
  const std::vector<YAML::Node> documents = YAML::LoadAll(text);
  if (documents.empty() || (documents.size() == 1 && documents.front().IsNull())) return {};
  if (documents.size() > 1) throw std::invalid_argument("there is more than one document");
  const YAML::Node& node = documents.front();
  if (!node.IsMap()) throw std::invalid_argument("the top level must be a dictionary");
  return Copy().map(node);
}

}  // namespace

ParameterMap parseYaml(const std::string& text) {
  try {
    return rootMap(text);
  } catch (const std::exception& error) {
    throw std::invalid_argument(printable(error.what(), bounds::kMostReason));  // it quotes bytes of the file
  }
}

std::string yamlText(const std::string& text) {
  YAML::Emitter plain;
  plain << text;
  try {
    const ParameterMap map = parseYaml(std::string("key: ") + plain.c_str());
    const auto* read = std::get_if<std::string>(&map.at("key").value);
    if (read != nullptr && *read == text) return plain.c_str();
  } catch (const std::exception&) {
    // it is quoted then
  }
  YAML::Emitter quoted;
  quoted << YAML::DoubleQuoted << text;
  return quoted.c_str();
}

ParameterMap loadYamlFile(const std::string& path) {
  const FileContent file = readFile(path, bounds::kMostYamlBytes);
  if (!file.ok()) throw std::invalid_argument(path + ": cannot be read: " + file.problem);
  try {
    return parseYaml(file.bytes);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

}  // namespace frontier_pilot
