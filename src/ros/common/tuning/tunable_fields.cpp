#include "ros/common/tuning/tunable_fields.h"

namespace frontier_pilot {

std::vector<TunableField> TunableFieldCollector::take() {
  std::vector<TunableField> taken;
  for (const std::string& name : tunable_) {
    const auto field =
        std::find_if(fields_.begin(), fields_.end(), [&](const TunableField& f) { return f.name == name; });
    if (field == fields_.end()) throw std::logic_error("no number or switch is called " + name);
    taken.push_back(*field);
  }
  return taken;
}

void TunableFieldCollector::add(const char* name, ParameterValue value, const Bounds& bounds, const std::string& unit,
                                const std::string& doc) {
  const std::string range = bounds.text();
  fields_.push_back({prefix_ + name, std::move(value), bounds,
                     doc + (unit.empty() ? "" : " [" + unit + "]") + (range.empty() ? "" : ", " + range)});
}

}  // namespace frontier_pilot
