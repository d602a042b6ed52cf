#include "exploration/limits/stopping_rules.h"

#include <cstdio>
#include <string>
#include <vector>

namespace frontier_pilot::exploration {
namespace {

void addRule(std::vector<std::string>& rules, const char* format, double value) {
  if (value <= 0.0) return;
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  rules.emplace_back(text);
}

}  // namespace

std::string UntilParameters::inWords() const {
  std::vector<std::string> rules;
  addRule(rules, "%g m2 are known", area);
  addRule(rules, "%g s have passed", time);
  addRule(rules, "%g m are driven", distance);
  addRule(rules, "the battery is at %g %%", 100.0 * battery);
  std::string text;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (i > 0) text += i + 1 == rules.size() ? " or " : ", ";
    text += rules[i];
  }
  return text;
}

std::optional<ExplorerReason> StoppingRules::met(double explored_area, const std::optional<double>& battery) const {
  if (until_.area > 0.0 && explored_area - area_before_ >= until_.area) return ExplorerReason::kUntilArea;
  if (until_.time > 0.0 && time() >= until_.time) return ExplorerReason::kUntilTime;
  if (until_.distance > 0.0 && distance_ >= until_.distance) return ExplorerReason::kUntilDistance;
  if (until_.battery > 0.0 && battery && *battery <= until_.battery) return ExplorerReason::kUntilBattery;
  return std::nullopt;
}

void StoppingRules::startOver(double explored_area) {
  time_ = {};
  distance_ = 0.0;
  area_before_ = explored_area;
}

}  // namespace frontier_pilot::exploration
