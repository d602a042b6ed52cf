#include "frontier_pilot/core/parameters.h"
#include "frontier_pilot/core/bounds.h"
#include "frontier_pilot/core/text.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <type_traits>

namespace frontier_pilot {
namespace {

std::string text(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

/// The number in `value`, an integer or a real; nullptr if it is something else. `storage` holds a converted integer.
const double* number(const ParameterValue& value, double& storage) {
  if (const auto* integer = std::get_if<std::int64_t>(&value.value)) {
    storage = static_cast<double>(*integer);
    return &storage;
  }
  return std::get_if<double>(&value.value);
}

std::string complaint(double value, const Bounds& bounds) {
  if (!std::isfinite(value)) return "must be finite, is " + text(value);
  if (!bounds.allows(value)) return "must be " + bounds.text() + ", is " + text(value);
  return {};
}

template <class T>
std::string joined(const std::vector<T>& values) {
  std::string out = "[";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if constexpr (std::is_same_v<T, double>) {
      out += (i > 0 ? ", " : "") + text(values[i]);
    } else {
      out += (i > 0 ? ", " : "") + joined(values[i]);
    }
  }
  return out + "]";
}

/// Reads a list of numbers into `read`. Returns what is wrong with it; empty if nothing is.
std::string readNumbers(const ParameterValue& value, const Bounds& bounds, std::vector<double>& read) {
  const auto* items = std::get_if<ParameterList>(&value.value);
  if (items == nullptr) return "must be a list of numbers";
  read.clear();
  for (const ParameterValue& item : *items) {
    double storage = 0.0;
    const double* one = number(item, storage);
    if (one == nullptr) return "must be a list of numbers";
    std::string bad = complaint(*one, bounds);
    if (!bad.empty()) return bad;
    read.push_back(*one);
  }
  return {};
}

}  // namespace

bool Bounds::allows(double value) const {
  return std::isfinite(value) && (exclusive_min ? value > min : value >= min) && value <= max;
}

std::string Bounds::text() const {
  const bool has_min = std::isfinite(min);
  const bool has_max = std::isfinite(max);
  std::string low = (exclusive_min ? "> " : ">= ") + frontier_pilot::text(min);
  const std::string high = "<= " + frontier_pilot::text(max);
  if (has_min && has_max) return low + " and " + high;
  if (has_min) return low;
  return has_max ? high : "";
}

std::string printRows(const std::vector<detail::Describer::Row>& rows) {
  std::ostringstream out;
  for (const auto& row : rows) out << row.name << ": " << row.value << (row.unit.empty() ? "" : " " + row.unit) << "\n";
  return out.str();
}

std::string tabulateRows(const std::vector<detail::Describer::Row>& rows) {
  std::ostringstream out;
  out << "| parameter | type | default | unit | allowed | meaning |\n|---|---|---|---|---|---|\n";
  for (const auto& row : rows) {
    out << "| `" << row.name << (row.tunable ? "` ↻ | " : "` | ") << row.type << " | " << row.value << " | " << row.unit
        << " | " << row.bounds << " | " << row.doc << " |\n";
  }
  return out.str();
}

namespace detail {

const ParameterValue* Loader::find(const char* name) {
  known_.emplace_back(name);
  const auto found = map_.find(name);
  return found == map_.end() ? nullptr : &found->second;
}

void Loader::moved(const char* name, const char* now) {
  if (find(name) != nullptr) problem(name, std::string("is called ") + now + " now");
}

void Loader::fixed(std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (find(name) != nullptr) problem(name, "is now a constant of the program and no longer a parameter");
  }
}

void Loader::problem(const std::string& name, const std::string& what) {
  problems_.push_back(prefix_ + name + ": " + what);
}

void Loader::reportUnknown() {
  for (const auto& [key, value] : map_) {
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) problem(key, "unknown parameter");
  }
}

void Loader::field(const char* name, bool& field, const char*, const char*) {
  const ParameterValue* value = find(name);
  if (value == nullptr) return;
  if (const auto* flag = std::get_if<bool>(&value->value)) {
    field = *flag;
  } else {
    problem(name, "must be true or false");
  }
}

void Loader::field(const char* name, int& field, const char*, const char*, const Bounds& bounds) {
  const ParameterValue* value = find(name);
  if (value == nullptr) return;
  double storage = 0.0;
  const double* read = number(*value, storage);
  const bool whole = read != nullptr && std::isfinite(*read) && *read == std::floor(*read);
  if (!whole) return problem(name, "must be a whole number");
  if (std::abs(*read) >= 2e9) return problem(name, "must be between -2e9 and 2e9, is " + text(*read));
  const std::string bad = complaint(*read, bounds);
  if (!bad.empty()) return problem(name, bad);
  field = static_cast<int>(*read);
}

void Loader::field(const char* name, double& field, const char*, const char*, const Bounds& bounds) {
  const ParameterValue* value = find(name);
  if (value == nullptr) return;
  double storage = 0.0;
  const double* read = number(*value, storage);
  if (read == nullptr) return problem(name, "must be a number");
  const std::string bad = complaint(*read, bounds);
  if (!bad.empty()) return problem(name, bad);
  field = *read;
}

void Loader::field(const char* name, std::string& field, const char*, const char*) {
  const ParameterValue* value = find(name);
  if (value == nullptr) return;
  if (const auto* read = std::get_if<std::string>(&value->value)) {
    field = *read;
  } else {
    problem(name, "must be a string");
  }
}

void Loader::field(const char* name, std::string& field, const char* unit, const char* doc, FrameName rule) {
  std::string read = field;
  this->field(name, read, unit, doc);
  if (read.empty() && rule == FrameName::kGiven) return problem(name, "must name a frame");
  if (read.size() > bounds::kMostName) return problem(name, "must have at most 256 characters");
  if (printable(read, bounds::kMostName) != read)
    return problem(name, "must not have control characters: no transform may have such a frame");
  if (read.rfind('/', 0) == 0) return problem(name, "must not begin with '/', is " + read + ": tf2 refuses such names");
  field = read;
}

void Loader::field(const char* name, std::vector<double>& field, const char*, const char*, const Bounds& bounds) {
  const ParameterValue* value = find(name);
  if (value == nullptr) return;
  std::vector<double> read;
  const std::string bad = readNumbers(*value, bounds, read);
  if (!bad.empty()) return problem(name, bad);
  field = read;
}

void Loader::field(const char* name, std::vector<std::vector<double>>& field, const char*, const char*,
                   const Bounds& bounds) {
  const ParameterValue* value = find(name);
  if (value == nullptr) return;
  const auto* items = std::get_if<ParameterList>(&value->value);
  if (items == nullptr) return problem(name, "must be a list of lists of numbers");
  std::vector<std::vector<double>> read;
  for (const ParameterValue& item : *items) {
    const std::string bad = readNumbers(item, bounds, read.emplace_back());
    if (!bad.empty()) return problem(name + ("[" + std::to_string(read.size() - 1) + "]"), bad);
  }
  field = read;
}

void Describer::tunable(std::initializer_list<const char*> names) {
  for (const char* name : names) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.name == prefix_ + name; });
    if (row != rows.end()) row->tunable = true;
  }
}

void Describer::field(const char* name, bool& field, const char* unit, const char* doc) {
  rows.push_back({prefix_ + name, "bool", unit, field ? "true" : "false", "", doc});
}

void Describer::field(const char* name, int& field, const char* unit, const char* doc, const Bounds& bounds) {
  rows.push_back({prefix_ + name, "int", unit, std::to_string(field), bounds.text(), doc});
}

void Describer::field(const char* name, double& field, const char* unit, const char* doc, const Bounds& bounds) {
  rows.push_back({prefix_ + name, "double", unit, text(field), bounds.text(), doc});
}

void Describer::field(const char* name, std::string& field, const char* unit, const char* doc) {
  rows.push_back({prefix_ + name, "string", unit, field.empty() ? "\"\"" : field, "", doc});
}

void Describer::field(const char* name, std::string& field, const char* unit, const char* doc, FrameName rule) {
  this->field(name, field, unit, doc);
  rows.back().bounds = rule == FrameName::kGiven ? "not empty, no leading /" : "no leading /";
}

void Describer::field(const char* name, std::vector<double>& field, const char* unit, const char* doc,
                      const Bounds& bounds) {
  rows.push_back({prefix_ + name, "list of double", unit, joined(field), bounds.text(), doc});
}

void Describer::field(const char* name, std::vector<std::vector<double>>& field, const char* unit, const char* doc,
                      const Bounds& bounds) {
  rows.push_back({prefix_ + name, "list of lists of double", unit, joined(field), bounds.text(), doc});
}

}  // namespace detail

}  // namespace frontier_pilot
