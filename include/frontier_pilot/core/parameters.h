#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot {

/// A value as YAML or the parameter server delivers it.
struct ParameterValue;
using ParameterList = std::vector<ParameterValue>;
using ParameterMap = std::map<std::string, ParameterValue>;
struct ParameterValue {
  std::variant<std::monostate, bool, std::int64_t, double, std::string, ParameterList, ParameterMap> value;
};

/// What is wrong with a configuration: one line per problem, each naming its key.
using Problems = std::vector<std::string>;

/// The numbers a field may hold. NaN and infinities are never allowed.
struct Bounds {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool exclusive_min = false;  ///< `min` itself is not allowed

  bool allows(double value) const;
  std::string text() const;
};
inline Bounds between(double min, double max) { return {min, max, false}; }
inline Bounds positiveUpTo(double max) { return {0.0, max, true}; }
/// How many, from `least` on. Every number of a configuration has a greatest value, because it may size a loop or a
/// sum, and far beyond what any robot needs nobody has tried it. [FLT-1]
inline Bounds countFrom(double least) { return between(least, 1e9); }
/// A place, or a direction, in a plane [m, rad].
inline Bounds coordinate() { return between(-bounds::kMostCoordinate, bounds::kMostCoordinate); }
/// What a base on wheels can do [m/s; rad/s; m/s^2 or rad/s^2]. With less than a thousandth it would hardly move, and
/// what is computed until it has stopped would have no end.
inline Bounds baseSpeed() { return between(0.001, 20.0); }
inline Bounds baseTurnRate() { return between(0.001, 50.0); }
inline Bounds baseAcceleration() { return between(0.001, 1000.0); }
/// A distance that a scanner measures, or that is compared with one [m].
inline Bounds scanRange() { return positiveUpTo(bounds::kMostRange); }
inline Bounds scanRangeOrNone() { return between(0.0, bounds::kMostRange); }
/// Rates [Hz] and periods [s] of repeated work. Timers run at them: at a rate that is too high a node would do nothing
/// else, and a period that is too long does not fit into ros::Duration. [FLT-1]
inline Bounds tickRate() { return between(0.1, 1000.0); }
inline Bounds tickPeriod() { return between(0.001, 3600.0); }
/// How long something may last [s]: up to eleven days, so that sums of several such times still fit into ros::Time.
inline Bounds timeSpan() { return positiveUpTo(1e6); }
inline Bounds timeSpanOrNone() { return between(0.0, 1e6); }
/// How old data may be that a robot drives by [s].
inline Bounds dataAge() { return positiveUpTo(10.0); }

/// Whether the name of a TF frame may be empty. A leading '/' is always refused, as by tf2. [FLT-1]
enum class FrameName { kGiven, kMayBeEmpty };

namespace detail {

template <class P, class = void>
struct HasCheck : std::false_type {};
template <class P>
struct HasCheck<P, std::void_t<decltype(std::declval<const P&>().check(std::declval<Problems&>()))>> : std::true_type {
};

/// Reads the described fields from a map; keys that no field has read at the end are reported as unknown.
class Loader {
 public:
  Loader(const ParameterMap& map, std::string prefix, Problems& problems)
      : map_(map), prefix_(std::move(prefix)), problems_(problems) {}

  void field(const char* name, bool& field, const char* unit, const char* doc);
  void field(const char* name, int& field, const char* unit, const char* doc, const Bounds& bounds);
  void field(const char* name, double& field, const char* unit, const char* doc, const Bounds& bounds);
  void field(const char* name, std::string& field, const char* unit, const char* doc);
  void field(const char* name, std::string& field, const char* unit, const char* doc, FrameName rule);
  void field(const char* name, std::vector<double>& field, const char* unit, const char* doc, const Bounds& bounds);
  void field(const char* name, std::vector<std::vector<double>>& field, const char* unit, const char* doc,
             const Bounds& bounds);
  template <class P>
  void group(const char* name, P& group, const char* doc);
  template <class P>
  void list(const char* name, std::vector<P>& list, const char* doc);

  /// A second name for a group: values under it override those under the first name, which `describe` must name before.
  template <class P>
  void alias(const char* name, P& group);
  /// The name that a parameter had in an earlier version, and what it is called now. Setting `name` is a problem.
  void moved(const char* name, const char* now);
  /// Names of parameters of an earlier version that are constants now. Setting one of them is a problem.
  void fixed(std::initializer_list<const char*> names);
  /// Names of parameters that may change while the node runs: fields that `describe` names, also in its groups ("a/b").
  void tunable(std::initializer_list<const char*>) {}

  template <class P>
  void load(P& parameters);

 private:
  const ParameterValue* find(const char* name);
  void problem(const std::string& name, const std::string& what);
  void reportUnknown();

  const ParameterMap& map_;
  std::string prefix_;
  Problems& problems_;
  std::vector<std::string> known_;
};

/// Collects the described fields as rows of text.
class Describer {
 public:
  struct Row {
    std::string name, type, unit, value, bounds, doc;
    bool tunable = false;  ///< may change while the node runs
  };
  explicit Describer(std::string prefix = {}) : prefix_(std::move(prefix)) {}

  void field(const char* name, bool& field, const char* unit, const char* doc);
  void field(const char* name, int& field, const char* unit, const char* doc, const Bounds& bounds);
  void field(const char* name, double& field, const char* unit, const char* doc, const Bounds& bounds);
  void field(const char* name, std::string& field, const char* unit, const char* doc);
  void field(const char* name, std::string& field, const char* unit, const char* doc, FrameName rule);
  void field(const char* name, std::vector<double>& field, const char* unit, const char* doc, const Bounds& bounds);
  void field(const char* name, std::vector<std::vector<double>>& field, const char* unit, const char* doc,
             const Bounds& bounds);
  template <class P>
  void group(const char* name, P& group, const char* doc);
  template <class P>
  void list(const char* name, std::vector<P>& list, const char* doc);
  template <class P>
  void alias(const char*, P&) {}
  void moved(const char*, const char*) {}
  void fixed(std::initializer_list<const char*>) {}
  /// Marks the rows of fields that were described before; those of an alias have no row.
  void tunable(std::initializer_list<const char*> names);

  std::vector<Row> rows;

 private:
  void append(const Describer& nested) { rows.insert(rows.end(), nested.rows.begin(), nested.rows.end()); }

  std::string prefix_;
};

}  // namespace detail

/// Overwrites the fields of `parameters` that `map` contains. `P::describe(visitor)` lists the fields once, for
/// loading, validation, printing and documentation; an optional `P::check(Problems&) const` adds conditions between
/// fields. Returns all problems, or an empty list: unknown keys, wrong types, values not finite or out of range.
template <class P>
Problems loadParameters(const ParameterMap& map, P& parameters, const std::string& prefix = {}) {
  Problems problems;
  detail::Loader(map, prefix, problems).load(parameters);
  return problems;
}

/// One row per field: its name, type, unit, current value, bounds and meaning.
template <class P>
std::vector<detail::Describer::Row> describeParameters(P parameters) {
  detail::Describer describer;
  parameters.describe(describer);
  return describer.rows;
}

/// `name: value unit` lines, for logging the effective configuration.
std::string printRows(const std::vector<detail::Describer::Row>& rows);

/// A Markdown table, for the documentation; the sign ↻ marks what may change while the node runs.
std::string tabulateRows(const std::vector<detail::Describer::Row>& rows);

/// Reads a YAML text into a map. Throws std::invalid_argument with the parser's message and position.
ParameterMap parseYaml(const std::string& text);

/// Reads a YAML file. Throws std::invalid_argument when it is missing, no regular file, larger than 1 MB or malformed.
ParameterMap loadYamlFile(const std::string& path);

/// `text` as a YAML scalar: quoted where it would be parsed as something else without quotes.
std::string yamlText(const std::string& text);

namespace detail {

template <class P>
void Loader::load(P& parameters) {
  parameters.describe(*this);
  reportUnknown();
  if constexpr (HasCheck<P>::value) {
    Problems own;
    parameters.check(own);
    for (const std::string& problem : own) problems_.push_back(prefix_ + problem);
  }
}

template <class P>
void Loader::group(const char* name, P& group, const char*) {
  const ParameterValue* value = find(name);
  if (value == nullptr) return;
  if (const auto* map = std::get_if<ParameterMap>(&value->value)) {
    Loader(*map, prefix_ + name + "/", problems_).load(group);
  } else {
    problem(name, "must be a dictionary");
  }
}

template <class P>
void Loader::alias(const char* name, P& group) {
  this->group(name, group, "");
}

template <class P>
void Loader::list(const char* name, std::vector<P>& list, const char*) {
  const ParameterValue* value = find(name);
  if (value == nullptr) return;
  const auto* items = std::get_if<ParameterList>(&value->value);
  if (items == nullptr) return problem(name, "must be a list of dictionaries");
  list.clear();
  for (std::size_t i = 0; i < items->size(); ++i) {
    const std::string item_name = std::string(name) + "[" + std::to_string(i) + "]";
    const auto* map = std::get_if<ParameterMap>(&(*items)[i].value);
    if (map == nullptr) {
      problem(item_name, "must be a dictionary");
      continue;
    }
    Loader(*map, prefix_ + item_name + "/", problems_).load(list.emplace_back());
  }
}

template <class P>
void Describer::group(const char* name, P& group, const char*) {
  Describer nested(prefix_ + name + "/");
  group.describe(nested);
  append(nested);
}

template <class P>
void Describer::list(const char* name, std::vector<P>& list, const char*) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    Describer nested(prefix_ + name + "[" + std::to_string(i) + "]/");
    list[i].describe(nested);
    append(nested);
  }
}

}  // namespace detail

}  // namespace frontier_pilot
