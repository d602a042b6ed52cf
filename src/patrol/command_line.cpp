#include "frontier_pilot/patrol/command_line.h"

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

/// The field that an option sets; nullptr if there is no such option.
double* targetOf(const std::string& option, PatrolOrder& goal) {
  if (option == "--side" || option == "--radius") return &goal.size;
  return option == "--laps" ? &goal.laps : nullptr;
}

}  // namespace

PatrolCommandLine parsePatrolCommandLine(const std::vector<std::string>& words) {
  PatrolOrder goal{0.0, 1.0, 1.0};
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
    if (i + 1 == parts.size()) return wrong(parts[i] + " needs a number");
    const std::optional<double> value = numberOf(parts[++i]);
    if (!value) return wrong(parts[i - 1] + " needs a number, not " + parts[i]);
    *target = *value;
  }
  if (goal.mode == 0.0) return wrong("no shape given: square, triangle or circle");
  return {goal, false, ""};
}

const char* patrolUsage() {
  return R"(usage: patrol_client SHAPE [--side METRES | --radius METRES] [--laps N]

Asks the patrol server (action turtlebot3) to drive a shape, left turns only, and
waits for the end. The robot comes back to where it stood.

  SHAPE              square, triangle or circle
  --side METRES      length of a side (default 1.0)
  --radius METRES    the same thing for a circle (default 1.0)
  --laps N           how often (default 1)
  -h, --help         this text

Prints a line when each leg starts. Ctrl-C stops the robot, waits until it is
stopped and ends; a second Ctrl-C does not wait.

Exit code:
  0    patrol complete
  1    aborted, refused or replaced by another patrol: the reason is printed
  2    wrong arguments
  3    no patrol server, or it died
  130  stopped by Ctrl-C

Example:
  rosrun frontier_pilot patrol_client square --side 1.0 --laps 2
)";
}

}  // namespace frontier_pilot::patrol
