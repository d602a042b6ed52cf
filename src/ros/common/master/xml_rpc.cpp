#include "ros/common/master/xml_rpc.h"

#include <ros/master.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcClient.h>

namespace frontier_pilot {
namespace {

using XmlRpc::XmlRpcValue;

constexpr double kAnswerPatience = 2.0;  // [s], although the comments of XmlRpcDispatch say milliseconds

/// An answer is [code, text, value]; the code 1 means success.
std::optional<XmlRpcValue> valueOf(XmlRpcValue& answer) {
  const bool complete = answer.getType() == XmlRpcValue::TypeArray && answer.size() == 3;
  if (!complete || answer[0].getType() != XmlRpcValue::TypeInt || static_cast<int>(answer[0]) != 1) return std::nullopt;
  return answer[2];
}

}  // namespace

std::optional<XmlRpcValue> requestFrom(const std::string& host, std::uint32_t port, const char* method,
                                       const XmlRpcValue& arguments) {
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  if (!client.executeNonBlock(method, arguments)) return std::nullopt;
  client._disp.work(kAnswerPatience);  // until the answer has arrived, or the time is over
  XmlRpcValue answer;
  if (!client.executeCheckDone(answer) || client.isFault()) return std::nullopt;
  return valueOf(answer);
}

std::optional<XmlRpcValue> requestFromMaster(const char* method, const XmlRpcValue& arguments) {
  return requestFrom(ros::master::getHost(), ros::master::getPort(), method, arguments);
}

std::optional<int> pidOfMaster() {
  XmlRpcValue request;
  request[0] = ros::this_node::getName();
  std::optional<XmlRpcValue> pid = requestFromMaster("getPid", request);
  if (!pid || pid->getType() != XmlRpcValue::TypeInt) return std::nullopt;
  return static_cast<int>(*pid);
}

}  // namespace frontier_pilot
