#include "frontier_pilot/ros/xml_rpc.h"

#include <ros/master.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include <thread>

#include "frontier_pilot/ros/clock.h"

namespace frontier_pilot {
namespace {

using XmlRpc::XmlRpcValue;

constexpr Duration kAnswerPatience = std::chrono::seconds(2);
constexpr std::chrono::milliseconds kAnswerPoll(1);

/// An answer is [code, text, value], and 1 is the code of success.
std::optional<XmlRpcValue> valueOf(XmlRpcValue& answer) {
  const bool complete = answer.getType() == XmlRpcValue::TypeArray && answer.size() == 3;
  if (!complete || answer[0].getType() != XmlRpcValue::TypeInt || static_cast<int>(answer[0]) != 1) return std::nullopt;
  return answer[2];
}

}  // namespace

std::optional<XmlRpcValue> requestFrom(const std::string& host, std::uint32_t port, const char* method,
                                       const XmlRpcValue& arguments) {
  const SteadyTime end = steadyNow() + kAnswerPatience;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  if (!client.executeNonBlock(method, arguments)) return std::nullopt;
  XmlRpcValue answer;
  while (!client.executeCheckDone(answer)) {
    if (steadyNow() >= end) return std::nullopt;  // the client's destructor closes the connection
    std::this_thread::sleep_for(kAnswerPoll);
  }
  return client.isFault() ? std::nullopt : valueOf(answer);
}

std::optional<XmlRpcValue> requestFromMaster(const char* method, const XmlRpcValue& arguments) {
  return requestFrom(ros::master::getHost(), ros::master::getPort(), method, arguments);
}

}  // namespace frontier_pilot
