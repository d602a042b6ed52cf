#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <vector>

namespace frontier_pilot {

/// The elements of an array. (XmlRpcValue's own iterators are for structs.) Throws XmlRpcException when it is none.
inline std::vector<XmlRpc::XmlRpcValue> elements(XmlRpc::XmlRpcValue& array) {
  std::vector<XmlRpc::XmlRpcValue> all(static_cast<std::size_t>(array.size()));
  int i = 0;
  for (XmlRpc::XmlRpcValue& element : all) element = array[i++];
  return all;
}

}  // namespace frontier_pilot
