#include "ros/common/master/parameter_values.h"

#include <cstdint>
#include <stdexcept>

#include "frontier_pilot/core/bounds.h"

namespace frontier_pilot {
namespace {

using XmlRpc::XmlRpcValue;

class Conversion {
 public:
  ParameterValue value(XmlRpcValue& value) {
    if (depth_ > bounds::kMostYamlDepth) throw std::length_error("values are nested more than 32 deep");
    if (++values_ > bounds::kMostYamlValues) throw std::length_error("more than 100000 values");
    ++depth_;
    ParameterValue converted = inner(value);
    --depth_;
    return converted;
  }

 private:
  ParameterValue inner(XmlRpcValue& value) {
    switch (value.getType()) {
      case XmlRpcValue::TypeBoolean:
        return {static_cast<bool>(value)};
      case XmlRpcValue::TypeInt:
        return {std::int64_t{static_cast<int>(value)}};
      case XmlRpcValue::TypeDouble:
        return {static_cast<double>(value)};
      case XmlRpcValue::TypeString:
        return {static_cast<std::string>(value)};
      case XmlRpcValue::TypeArray:
        return {list(value)};
      case XmlRpcValue::TypeStruct:
        return {map(value)};
      default:
        return {};
    }
  }
  ParameterList list(XmlRpcValue& array) {
    ParameterList list;
    const int size = array.size();  // XmlRpcValue's iterators are those of dictionaries
    for (int i = 0; i < size; ++i) list.push_back(value(array[i]));
    return list;
  }
  ParameterMap map(XmlRpcValue& dictionary) {
    ParameterMap map;
    for (auto& [name, item] : dictionary) map[name] = value(item);
    return map;
  }

  int depth_ = 0;
  int values_ = 0;
};

}  // namespace

ParameterValue toParameterValue(XmlRpcValue& value) { return Conversion().value(value); }

}  // namespace frontier_pilot
