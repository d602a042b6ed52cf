#include <yaml-cpp/yaml.h>

#include <stdexcept>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot {
namespace {

ParameterValue convert(const YAML::Node& node);

ParameterValue scalar(const YAML::Node& node) {
  // A quoted scalar carries the tag "!": it is a text, whatever it looks like.
  if (node.Tag() == "!") return {node.Scalar()};
  bool flag = false;
  std::int64_t integer = 0;
  double real = 0.0;
  if (YAML::convert<std::int64_t>::decode(node, integer)) return {integer};
  if (YAML::convert<double>::decode(node, real)) return {real};
  if (YAML::convert<bool>::decode(node, flag)) return {flag};
  return {node.Scalar()};
}

ParameterMap convertMap(const YAML::Node& node) {
  ParameterMap map;
  for (const auto& entry : node) map[entry.first.Scalar()] = convert(entry.second);
  return map;
}

ParameterValue convert(const YAML::Node& node) {
  if (node.IsMap()) return {convertMap(node)};
  if (node.IsScalar()) return scalar(node);
  if (!node.IsSequence()) return {};
  ParameterList list;
  for (const auto& item : node) list.push_back(convert(item));
  return {list};
}

ParameterMap rootMap(const YAML::Node& node) {
  if (node.IsNull()) return {};
  if (!node.IsMap()) throw std::invalid_argument("the top level must be a dictionary");
  return convertMap(node);
}

}  // namespace

ParameterMap parseYaml(const std::string& text) {
  try {
    return rootMap(YAML::Load(text));
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument(error.what());
  }
}

std::string yamlText(const std::string& text) {
  YAML::Emitter emitter;
  emitter << text;
  return emitter.c_str();
}

ParameterMap loadYamlFile(const std::string& path) {
  constexpr std::size_t kMostBytes = 1000000;
  const FileContent file = readFile(path, kMostBytes);
  if (!file.ok()) throw std::invalid_argument(path + ": cannot be read: " + file.problem);
  try {
    return rootMap(YAML::Load(file.bytes));
  } catch (const std::exception& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

}  // namespace frontier_pilot
