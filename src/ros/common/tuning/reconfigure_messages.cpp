#include "ros/common/tuning/reconfigure_messages.h"

#include <cstdint>

namespace frontier_pilot {
namespace {

using dynamic_reconfigure::Config;

constexpr const char* kGroup = "Default";

void add(Config& msg, const std::string& name, bool value) {
  dynamic_reconfigure::BoolParameter parameter;
  parameter.name = name;
  parameter.value = static_cast<std::uint8_t>(value);
  msg.bools.push_back(parameter);
}

void add(Config& msg, const std::string& name, std::int64_t value) {
  dynamic_reconfigure::IntParameter parameter;
  parameter.name = name;
  parameter.value = static_cast<std::int32_t>(value);
  msg.ints.push_back(parameter);
}

void add(Config& msg, const std::string& name, double value) {
  dynamic_reconfigure::DoubleParameter parameter;
  parameter.name = name;
  parameter.value = value;
  msg.doubles.push_back(parameter);
}

void add(Config& msg, const TunableField& field) {
  if (const auto* flag = std::get_if<bool>(&field.value.value)) add(msg, field.name, *flag);
  if (const auto* whole = std::get_if<std::int64_t>(&field.value.value)) add(msg, field.name, *whole);
  if (const auto* number = std::get_if<double>(&field.value.value)) add(msg, field.name, *number);
}

const char* typeOf(const TunableField& field) {
  if (std::holds_alternative<bool>(field.value.value)) return "bool";
  return std::holds_alternative<std::int64_t>(field.value.value) ? "int" : "double";
}

/// `field` with one of its bounds as its value.
TunableField atBound(TunableField field, bool upper) {
  const double bound = upper ? field.bounds.max : field.bounds.min;
  if (std::holds_alternative<bool>(field.value.value)) {
    field.value.value = upper;
  } else if (std::holds_alternative<std::int64_t>(field.value.value)) {
    using Whole = std::numeric_limits<std::int32_t>;
    field.value.value =
        static_cast<std::int64_t>(std::clamp<double>(bound, double{Whole::min()}, double{Whole::max()}));
  } else {
    field.value.value = bound;
  }
  return field;
}

void addGroup(Config& msg) {
  dynamic_reconfigure::GroupState group;
  group.name = kGroup;
  group.state = 1;
  msg.groups.push_back(group);
}

/// Puts `value` under the path `name` ("a/b").
void put(ParameterMap& map, const std::string& name, const ParameterValue& value) {
  const std::size_t slash = name.find('/');
  if (slash == std::string::npos) {
    map[name] = value;
    return;
  }
  ParameterValue& group = map[name.substr(0, slash)];
  if (!std::holds_alternative<ParameterMap>(group.value)) group.value = ParameterMap();
  put(std::get<ParameterMap>(group.value), name.substr(slash + 1), value);
}

/// Collects what a request asks for.
class ChangeReader {
 public:
  ChangeReader(const std::vector<TunableField>& fields, Problems& problems) : fields_(fields), problems_(problems) {}

  void read(const std::string& name, const ParameterValue& value, const char* type) {
    const auto field =
        std::find_if(fields_.begin(), fields_.end(), [&](const TunableField& f) { return f.name == name; });
    if (field == fields_.end()) {
      problems_.push_back(name + ": is no parameter that may change while the node runs");
    } else if (field->value.value.index() != value.value.index()) {
      problems_.push_back(name + ": must be of type " + typeOf(*field) + ", is of type " + type);
    } else {
      put(changes_, name, value);
    }
  }
  ParameterMap take() { return std::move(changes_); }

 private:
  const std::vector<TunableField>& fields_;
  Problems& problems_;
  ParameterMap changes_;
};

}  // namespace

Config toConfigMsg(const std::vector<TunableField>& fields) {
  Config msg;
  for (const TunableField& field : fields) add(msg, field);
  addGroup(msg);
  return msg;
}

dynamic_reconfigure::ConfigDescription toDescriptionMsg(const std::vector<TunableField>& defaults) {
  dynamic_reconfigure::ConfigDescription msg;
  dynamic_reconfigure::Group group;
  group.name = kGroup;
  for (const TunableField& field : defaults) {
    dynamic_reconfigure::ParamDescription parameter;
    parameter.name = field.name;
    parameter.type = typeOf(field);
    parameter.description = field.meaning;
    group.parameters.push_back(parameter);
    add(msg.min, atBound(field, false));
    add(msg.max, atBound(field, true));
  }
  msg.groups.push_back(group);
  msg.dflt = toConfigMsg(defaults);
  addGroup(msg.min);
  addGroup(msg.max);
  return msg;
}

ParameterMap toChanges(const Config& msg, const std::vector<TunableField>& fields, Problems& problems) {
  ChangeReader reader(fields, problems);
  for (const auto& parameter : msg.bools) reader.read(parameter.name, {parameter.value != 0}, "bool");
  for (const auto& parameter : msg.ints) reader.read(parameter.name, {std::int64_t{parameter.value}}, "int");
  for (const auto& parameter : msg.doubles) reader.read(parameter.name, {parameter.value}, "double");
  for (const auto& parameter : msg.strs) reader.read(parameter.name, {parameter.value}, "str");
  return reader.take();
}

}  // namespace frontier_pilot
