#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace frontier_pilot {

/// The elements of an array. (XmlRpcValue's own iterators are for structs.) Throws XmlRpcException if it is not an
/// array.
inline std::vector<XmlRpc::XmlRpcValue> elements(XmlRpc::XmlRpcValue& array) {
  std::vector<XmlRpc::XmlRpcValue> all(static_cast<std::size_t>(array.size()));
  int i = 0;
  for (XmlRpc::XmlRpcValue& element : all) element = array[i++];
  return all;
}

/// An answer of ROS' XML-RPC API.
struct RpcAnswer {
  bool success = false;
  XmlRpc::XmlRpcValue value;  ///< of no meaning without success
};

/// Calls a method of the master; nothing if there is no answer within two seconds. ros::master::execute would wait
/// forever for a master that hangs.
std::optional<RpcAnswer> askTheMaster(const char* method, const XmlRpc::XmlRpcValue& arguments);
/// Calls a method of ROS' XML-RPC API and returns the value of the answer; nothing if there is no answer within two
/// seconds, or if it is an error.
std::optional<XmlRpc::XmlRpcValue> requestFrom(const std::string& host, std::uint32_t port, const char* method,
                                               const XmlRpc::XmlRpcValue& arguments);
/// The same, at the master.
std::optional<XmlRpc::XmlRpcValue> requestFromMaster(const char* method, const XmlRpc::XmlRpcValue& arguments);
/// The process id of the master; nothing if it does not answer.
std::optional<int> pidOfMaster();

}  // namespace frontier_pilot
