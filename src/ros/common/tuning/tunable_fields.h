#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "frontier_pilot/core/parameters.h"

namespace frontier_pilot {

/// A parameter that may change while the node runs.
struct TunableField {
  std::string name;      ///< with its groups: "limits/max_linear"
  ParameterValue value;  ///< a bool, an integer or a double, which is its type
  Bounds bounds;         ///< of a number
  std::string meaning;   ///< with its unit
};

/// A visitor that collects the fields which `describe` names as tunable. A group with a second name is listed under
/// that one as well. Lists and texts cannot be tuned.
class TunableFieldCollector {
 public:
  explicit TunableFieldCollector(std::string prefix = {}) : prefix_(std::move(prefix)) {}

  void field(const char* name, bool& field, const char* unit, const char* doc) { add(name, {field}, {}, unit, doc); }
  void field(const char* name, int& field, const char* unit, const char* doc, const Bounds& bounds) {
    add(name, {std::int64_t{field}}, bounds, unit, doc);
  }
  void field(const char* name, double& field, const char* unit, const char* doc, const Bounds& bounds) {
    add(name, {field}, bounds, unit, doc);
  }
  template <class T, class... Rest>
  void field(const char*, T&, const char*, const char*, const Rest&...) {}
  template <class P>
  void group(const char* name, P& group, const char*) {
    TunableFieldCollector nested(prefix_ + name + "/");
    group.describe(nested);
    append(fields_, nested.fields_);
    append(tunable_, nested.tunable_);
  }
  template <class P>
  void alias(const char* name, P& group) {
    this->group(name, group, "");
  }
  template <class P>
  void list(const char*, std::vector<P>&, const char*) {}
  void moved(const char*, const char*) {}
  void fixed(std::initializer_list<const char*>) {}
  void tunable(std::initializer_list<const char*> names) {
    for (const char* name : names) tunable_.push_back(prefix_ + name);
  }

  /// In the order in which they are named as tunable. Throws std::logic_error if one of these names has no field.
  std::vector<TunableField> take();

 private:
  template <class T>
  static void append(std::vector<T>& all, const std::vector<T>& more) {
    all.insert(all.end(), more.begin(), more.end());
  }
  void add(const char* name, ParameterValue value, const Bounds& bounds, const std::string& unit,
           const std::string& doc);

  std::string prefix_;
  std::vector<TunableField> fields_;
  std::vector<std::string> tunable_;
};

/// The tunable fields of `parameters`, with their values.
template <class P>
std::vector<TunableField> tunableFields(P parameters) {
  TunableFieldCollector collector;
  parameters.describe(collector);
  return collector.take();
}

/// The tunable parameters of a node, whatever the type of its struct.
struct Tunables {
  std::vector<TunableField> defaults;
  std::function<std::vector<TunableField>()> inForce;
  /// Changes several at once, or none if there is a problem with one of them.
  std::function<Problems(const ParameterMap& changes)> change;
};

/// `parameters` are those that the node was started with; `apply` hands changed ones, which are free of problems, to
/// the node.
template <class P>
Tunables tunablesOf(const P& parameters, std::function<void(const P&)> apply) {
  const auto in_force = std::make_shared<P>(parameters);
  return {tunableFields(P()), [in_force] { return tunableFields(*in_force); },
          [in_force, apply = std::move(apply)](const ParameterMap& changes) {
            P changed = *in_force;
            Problems problems = loadParameters(changes, changed);
            if (!problems.empty()) return problems;
            apply(changed);
            *in_force = changed;
            return problems;
          }};
}

}  // namespace frontier_pilot
