#include "ros/common/help/node_usage.h"

#include <dynamic_reconfigure/ConfigDescription.h>
#include <dynamic_reconfigure/Reconfigure.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include "frontier_pilot/core/files.h"
#include "ros/common/names.h"

namespace frontier_pilot {
namespace {

using Row = detail::Describer::Row;

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

void section(std::ostringstream& out, const char* title, const std::vector<NamedPort>& ports) {
  if (ports.empty()) return;
  std::size_t width = 0;
  for (const NamedPort& port : ports) width = std::max(width, port.name.size());
  out << "\n" << title << "\n";
  for (const NamedPort& port : ports) out << "  " << padded(port.name, width) << "  " << port.type << "\n";
}

void parameterSection(std::ostringstream& out, const NodeUsage& usage) {
  if (usage.parameters.empty()) return;
  const std::vector<Row> rows = rowsNamed(usage.parameters, usage.main_parameters);
  std::size_t width = 0;
  for (const Row& row : rows) width = std::max(width, row.name.size());
  out << "\nmain parameters, with their defaults (docs/parameters.md has all " << withOneItem(usage.parameters).size()
      << ")\n";
  for (const Row& row : rows) {
    out << "  ~" << padded(row.name, width) << "  " << row.value << (row.unit.empty() ? "" : " " + row.unit) << "  "
        << row.doc << "\n";
  }
}

/// `name[3]/key` as `name[i]/key`.
std::string withoutIndex(const std::string& name) {
  const std::size_t open = name.find('['), close = name.find(']');
  if (open == std::string::npos || close == std::string::npos) return name;
  return name.substr(0, open) + "[i" + name.substr(close);
}

}  // namespace

void addTuningPorts(NodeUsage& usage) {
  const std::string node = usage.name + "/";
  usage.publishes.push_back(port<dynamic_reconfigure::ConfigDescription>(node + names::kParameterDescriptions));
  usage.publishes.push_back(port<dynamic_reconfigure::Config>(node + names::kParameterUpdates));
  usage.services.push_back(servicePort<dynamic_reconfigure::Reconfigure>(node + names::kSetParameters));
}

std::vector<Row> withOneItem(const std::vector<Row>& rows) {
  std::vector<Row> merged;
  for (const Row& row : rows) {
    const std::string name = withoutIndex(row.name);
    const auto known = std::find_if(merged.begin(), merged.end(), [&](const Row& m) { return m.name == name; });
    if (known == merged.end()) {
      merged.push_back(row);
      merged.back().name = name;
    } else if (known->value != row.value) {
      known->value += ", " + row.value;
    }
  }
  return merged;
}

std::vector<Row> rowsNamed(const std::vector<Row>& rows, const std::vector<std::string>& names) {
  std::vector<Row> named;
  for (const Row& row : withOneItem(rows)) {
    if (contains(names, row.name)) named.push_back(row);
  }
  return named;
}

std::string helpOf(const NodeUsage& usage) {
  std::ostringstream out;
  out << "usage: rosrun frontier_pilot " << usage.name << (usage.arguments.empty() ? "" : " ") << usage.arguments
      << "\n\n"
      << usage.purpose << "\n";
  if (!usage.options.empty()) out << "\n" << usage.options;
  section(out, "reads", usage.reads);
  section(out, "publishes", usage.publishes);
  section(out, "services", usage.services);
  section(out, "actions", usage.actions);
  section(out, "calls", usage.calls);
  parameterSection(out, usage);
  out << "\nexit codes\n" << usage.exit_codes;
  if (!usage.example.empty()) out << "\nexample\n  " << usage.example << "\n";
  return out.str();
}

int printHelp(const NodeUsage& usage) {
  std::cout << helpOf(usage);
  const std::string problem = flushStandardOutput();
  if (problem.empty()) return 0;
  std::cerr << usage.name << ": " << problem << std::endl;
  return 1;
}

std::optional<int> answerCommandLine(const std::vector<std::string>& words, const NodeUsage& usage) {
  if (contains(words, "--help") || contains(words, "-h")) return printHelp(usage);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].find(":=") != std::string::npos) continue;
    if (i + 1 < words.size() && contains(usage.library_options, words[i])) {
      ++i;
      continue;
    }
    std::cerr << usage.name << ": unknown argument '" << words[i] << "'; '" << usage.name
              << " --help' lists what it takes" << std::endl;
    return 2;
  }
  return std::nullopt;
}

}  // namespace frontier_pilot
