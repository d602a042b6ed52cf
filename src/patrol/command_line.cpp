#include "frontier_pilot/patrol/command_line.h"

#include <cmath>
#include <cstdlib>

namespace frontier_pilot::patrol {
namespace {

/// The mode of the shape with this name; 0 if there is none.
double modeOf(const std::string& word) {
  for (const PatrolShape shape : {PatrolShape::kSquare, PatrolShape::kTriangle, PatrolShape::kCircle}) {
    if (word == toString(shape)) return static_cast<double>(shape);
  }
  return 0.0;
}

std::optional<double> numberOf(const std::string& word) {
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (word.empty() || end != word.c_str() + word.size()) return std::nullopt;
  return value;
}

PatrolCommandLine wrong(const std::string& problem) { return {std::nullopt, false, problem}; }

/// Splits --option=value into two words.
std::vector<std::string> split(const std::vector<std::string>& words) {
  std::vector<std::string> out;
  for (const std::string& word : words) {
    const std::size_t equals = word.rfind("--", 0) == 0 ? word.find('=') : std::string::npos;
    out.push_back(word.substr(0, equals));
    if (equals != std::string::npos) out.push_back(word.substr(equals + 1));
  }
  return out;
}

/// What is wrong with the value of an option; empty if nothing is.
std::string complaintOf(const std::string& option, const std::string& word, double value) {
  if (option != "--laps") return value > 0.0 && std::isfinite(value) ? "" : option + " must be above 0 m, not " + word;
  return value >= 1.0 && value == std::floor(value) && std::isfinite(value)
             ? ""
             : option + " must be a whole number, at least 1, not " + word;
}

/// The field that an option sets; nullptr if there is no such option.
double* targetOf(const std::string& option, PatrolOrder& goal) {
  if (option == "--side" || option == "--radius") return &goal.size;
  return option == "--laps" ? &goal.laps : nullptr;
}

}  // namespace

PatrolCommandLine parsePatrolCommandLine(const std::vector<std::string>& words) {
  PatrolOrder goal{0.0, 1.0, 1.0};
  std::string size;  // the option that gave it
  const std::vector<std::string> parts = split(words);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] == "--help" || parts[i] == "-h") return {std::nullopt, true, ""};
    if (const double mode = modeOf(parts[i]); mode != 0.0) {
      if (goal.mode != 0.0) return wrong("more than one shape: " + parts[i]);
      goal.mode = mode;
      continue;
    }
    double* target = targetOf(parts[i], goal);
    if (target == nullptr) return wrong("unknown argument: " + parts[i]);
    if (target == &goal.size) {
      if (!size.empty() && size != parts[i]) return wrong("not both " + size + " and " + parts[i]);
      size = parts[i];
    }
    if (i + 1 == parts.size()) return wrong(parts[i] + " needs a number");
    const std::optional<double> value = numberOf(parts[++i]);
    if (!value) return wrong(parts[i - 1] + " needs a number, not " + parts[i]);
    if (const std::string bad = complaintOf(parts[i - 1], parts[i], *value); !bad.empty()) return wrong(bad);
    *target = *value;
  }
  if (goal.mode == 0.0) return wrong("no shape given: square, triangle or circle");
  return {goal, false, ""};
}

}  // namespace frontier_pilot::patrol
