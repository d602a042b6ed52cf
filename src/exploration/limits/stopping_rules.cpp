#include "exploration/limits/stopping_rules.h"

#include <cmath>
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

std::string UntilParameters::inWords(double explored_before) const {
  std::vector<std::string> rules;
  const double rounded = std::round(10.0 * explored_before) / 10.0;
  if (area > 0.0) addRule(rules, "%g m2 are known", area + rounded);
  addRule(rules, "%g s have passed", time);
  addRule(rules, "%g m are driven", distance);
  addRule(rules, "the battery is at %g %%", 100.0 * battery);
  addRule(rules, "%g %% of the estimated floor is explored", 100.0 * share);
  std::string text;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (i > 0) text += i + 1 == rules.size() ? " or " : ", ";
    text += rules[i];
  }
  return text;
}

std::optional<ExplorerReason> StoppingRules::met(const State& state) const {
  if (until_.area > 0.0 && state.explored_area - area_before_ >= until_.area) return ExplorerReason::kUntilArea;
  if (until_.time > 0.0 && time() >= until_.time) return ExplorerReason::kUntilTime;
  if (until_.distance > 0.0 && distance_ >= until_.distance) return ExplorerReason::kUntilDistance;
  if (until_.battery > 0.0 && state.battery && *state.battery <= until_.battery) return ExplorerReason::kUntilBattery;
  const bool share_counts = until_.share > 0.0 && share_counts_ && state.share_estimated;
  if (share_counts && state.share && *state.share >= until_.share) return ExplorerReason::kUntilShare;
  return std::nullopt;
}

void StoppingRules::startOver(const State& state) {
  time_ = {};
  distance_ = 0.0;
  area_before_ = state.explored_area;
  share_counts_ = !state.share_estimated || !state.share || *state.share < until_.share;
}

}  // namespace frontier_pilot::exploration
