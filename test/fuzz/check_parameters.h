#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "frontier_pilot/core/parameters.h"
#include "fuzz/fuzz.h"

namespace frontier_pilot::fuzz {

/// Visits the fields of parameters, and requires that their values are allowed.
class BoundsCheck {
 public:
  void field(const char*, bool&, const char*, const char*) {}
  void field(const char*, std::string&, const char*, const char*) {}
  void field(const char*, std::string& value, const char*, const char*, FrameName rule) {
    require(rule == FrameName::kMayBeEmpty || !value.empty(), "a frame has a name");
    require(value.empty() || value[0] != '/', "the name of a frame does not begin with a slash");
  }
  void field(const char*, int& value, const char*, const char*, const Bounds& bounds) { check(value, bounds); }
  void field(const char*, double& value, const char*, const char*, const Bounds& bounds) { check(value, bounds); }
  void field(const char*, std::vector<double>& values, const char*, const char*, const Bounds& bounds) {
    for (const double value : values) check(value, bounds);
  }
  void field(const char*, std::vector<std::vector<double>>& lists, const char*, const char*, const Bounds& bounds) {
    for (const std::vector<double>& values : lists) {
      for (const double value : values) check(value, bounds);
    }
  }
  template <class P>
  void group(const char*, P& group, const char*) {
    group.describe(*this);
  }
  template <class P>
  void list(const char*, std::vector<P>& list, const char*) {
    for (P& item : list) item.describe(*this);
  }
  template <class P>
  void alias(const char*, P&) {}
  void moved(const char*, const char*) {}
  void fixed(std::initializer_list<const char*>) {}
  void tunable(std::initializer_list<const char*>) {}

 private:
  /// NaN is the default of what need not be given, and cannot be given.
  static void check(double value, const Bounds& bounds) {
    require(value != value || bounds.allows(value), "a number is within its bounds");
  }
};

/// Loads `map` into the parameters `P`, and checks what was accepted.
template <class P>
void load(const ParameterMap& map) {
  P parameters;
  if (!loadParameters(map, parameters).empty()) return;
  BoundsCheck check;
  parameters.describe(check);
  printRows(describeParameters(parameters));
}

/// Loads `map` into the parameters of every module.
void loadAll(const ParameterMap& map);

}  // namespace frontier_pilot::fuzz
