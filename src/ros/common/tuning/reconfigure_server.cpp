#include "ros/common/tuning/reconfigure_server.h"

#include <dynamic_reconfigure/ConfigDescription.h>

#include <sstream>

#include "ros/common/names.h"
#include "ros/common/throttled_log.h"
#include "ros/common/tuning/reconfigure_messages.h"

namespace frontier_pilot {
namespace {

XmlRpc::XmlRpcValue toXmlRpc(const ParameterValue& value) {
  if (const auto* flag = std::get_if<bool>(&value.value)) return {*flag};
  if (const auto* whole = std::get_if<std::int64_t>(&value.value)) return {static_cast<int>(*whole)};
  return {std::get<double>(value.value)};
}

std::string textOf(const ParameterValue& value) {
  std::ostringstream out;
  out << std::boolalpha;
  std::visit(
      [&out](const auto& v) {
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(v)>>) out << v;
      },
      value.value);
  return out.str();
}

}  // namespace

ReconfigureServer::ReconfigureServer(NodeConnections& connections, Tunables tunables)
    : tunables_(std::move(tunables)), master_(connections.master()) {
  ros::NodeHandle private_node("~");
  descriptions_ =
      private_node.advertise<dynamic_reconfigure::ConfigDescription>(names::kParameterDescriptions, 1, true);
  updates_ = private_node.advertise<dynamic_reconfigure::Config>(names::kParameterUpdates, 1, true);
  descriptions_.publish(toDescriptionMsg(tunables_.defaults));
  updates_.publish(toConfigMsg(tunables_.inForce()));
  connections.serve(private_node.resolveName(names::kSetParameters), &ReconfigureServer::handle, this);
}

bool ReconfigureServer::handle(Request& request, Response& response) {
  const std::vector<TunableField> before = tunables_.inForce();
  const Problems problems = change(request.config);
  for (const std::string& problem : problems) THROTTLED_WARN("parameters not changed: " << problem);
  if (problems.empty()) tell(before);
  response.config = toConfigMsg(tunables_.inForce());
  updates_.publish(response.config);  // also when nothing has changed: a client may show what was refused
  return true;
}

Problems ReconfigureServer::change(const dynamic_reconfigure::Config& wanted) const {
  Problems problems;
  const ParameterMap changes = toChanges(wanted, tunables_.inForce(), problems);
  return problems.empty() ? tunables_.change(changes) : problems;
}

void ReconfigureServer::tell(const std::vector<TunableField>& before) {
  const std::vector<TunableField> after = tunables_.inForce();
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (toXmlRpc(after[i].value) == toXmlRpc(before[i].value)) continue;
    THROTTLED_INFO("parameter " << after[i].name << " changed: " << textOf(before[i].value) << " -> "
                                << textOf(after[i].value));
    master_.setParameter(after[i].name, toXmlRpc(after[i].value));
  }
}

}  // namespace frontier_pilot
