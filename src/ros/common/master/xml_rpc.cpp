#include "ros/common/master/xml_rpc.h"

#include <ros/master.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <utility>

namespace frontier_pilot {
namespace {

using XmlRpc::XmlRpcValue;

constexpr double kAnswerPatience = 2.0;  // [s], although the comments of XmlRpcDispatch say milliseconds

/// An answer is [code, text, value]; the code 1 means success.
std::optional<RpcAnswer> read(XmlRpcValue& answer) {
  const bool complete = answer.getType() == XmlRpcValue::TypeArray && answer.size() == 3;
  if (!complete || answer[0].getType() != XmlRpcValue::TypeInt) return std::nullopt;
  return RpcAnswer{static_cast<int>(answer[0]) == 1, answer[2]};
}

std::optional<RpcAnswer> ask(const std::string& host, std::uint32_t port, const char* method,
                             const XmlRpcValue& arguments) {
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  if (!client.executeNonBlock(method, arguments)) return std::nullopt;
  client._disp.work(kAnswerPatience);  // until the answer has arrived, or the time is over
  XmlRpcValue answer;
  if (!client.executeCheckDone(answer) || client.isFault()) return std::nullopt;
  return read(answer);
}

std::optional<XmlRpcValue> valueOf(std::optional<RpcAnswer> answer) {
  if (!answer || !answer->success) return std::nullopt;
  return std::move(answer->value);
}

}  // namespace

std::optional<RpcAnswer> askTheMaster(const char* method, const XmlRpcValue& arguments) {
  return ask(ros::master::getHost(), ros::master::getPort(), method, arguments);
}

std::optional<XmlRpcValue> requestFrom(const std::string& host, std::uint32_t port, const char* method,
                                       const XmlRpcValue& arguments) {
  return valueOf(ask(host, port, method, arguments));
}

std::optional<XmlRpcValue> requestFromMaster(const char* method, const XmlRpcValue& arguments) {
  return valueOf(askTheMaster(method, arguments));
}

std::optional<int> pidOfMaster() {
  XmlRpcValue request;
  request[0] = ros::this_node::getName();
  std::optional<XmlRpcValue> pid = requestFromMaster("getPid", request);
  if (!pid || pid->getType() != XmlRpcValue::TypeInt) return std::nullopt;
  return static_cast<int>(*pid);
}

}  // namespace frontier_pilot
