#include "ros/fleet_stop/regained_services.h"

#include "ros/fleet_stop/stop_answer.h"

namespace frontier_pilot {

std::vector<std::string> RegainedServices::take(const NodesByName& publishers, const NodesByName& providers) {
  std::vector<std::string> regained;
  for (const auto& [topic, nodes] : publishers) {
    const std::string service = serviceBeside(topic);
    if (service.empty()) continue;
    const std::vector<std::string> current = nodesOf(providers, service);
    const std::string provider = current.empty() ? std::string() : current.front();
    const auto [before, is_first] = provider_.emplace(service, provider);
    if (before->second == provider) continue;
    before->second = provider;
    if (isNodeOf(publishers, topic, provider)) regained.push_back(service);
  }
  return regained;
}

}  // namespace frontier_pilot
