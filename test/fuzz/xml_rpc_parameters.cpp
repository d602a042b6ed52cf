// The parameters of all modules, as the parameter server sends them: an XML-RPC value.

#include <xmlrpcpp/XmlRpcException.h>

#include <stdexcept>

#include "fuzz/check_parameters.h"
#include "ros/common/master/parameter_values.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace frontier_pilot;  // NOLINT(google-build-using-namespace): a program of its own
  const std::string xml = fuzz::textOf(data, size);
  int offset = 0;
  XmlRpc::XmlRpcValue value;
  if (!value.fromXml(xml, &offset)) return 0;
  try {
    const ParameterValue read = toParameterValue(value);
    if (const auto* map = std::get_if<ParameterMap>(&read.value)) fuzz::loadAll(*map);
  } catch (const std::length_error&) {
  }
  return 0;
}
